#include "studio/app/key_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "studio/app/commands.h"
#include "studio/app/fuzzy_match.h"
#include "studio/app/key_bindings.h"
#include "studio/app/key_field.h"

namespace kumite::studio {

namespace {

QString nameOf(const Command& command) {
    return QStringLiteral("%1 (%2)").arg(command.plainText(), command.plainMenu());
}

}  // namespace

KeyEditor::KeyEditor(CommandTable& commands, QWidget* parent)
    : QWidget(parent),
      commands_(commands),
      search_(new QLineEdit(this)),
      tree_(new QTreeWidget(this)),
      field_(new KeyField(this)),
      assign_(new QPushButton(this)),
      remove_(new QPushButton(tr("Remove keys"), this)),
      reset_(new QPushButton(tr("Reset"), this)),
      resetAll_(new QPushButton(tr("Reset all keys"), this)),
      conflict_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 12, 0, 0);
    layout->setSpacing(8);
    search_->setPlaceholderText(tr("Search commands"));
    search_->setAccessibleName(tr("Search commands"));
    search_->setToolTip(tr("Shows the commands whose name, menu or key holds these letters."));
    layout->addWidget(search_);
    tree_->setAccessibleName(tr("Commands and their keys"));
    tree_->setToolTip(tr("Choose a command, then press its key in the field below"));
    tree_->setColumnCount(3);
    tree_->setHeaderLabels({tr("command"), tr("menu"), tr("keys")});
    tree_->setRootIsDecorated(false);
    tree_->setUniformRowHeights(true);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    tree_->header()->setStretchLastSection(false);
    layout->addWidget(tree_, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    field_->setFixedWidth(150);
    row->addWidget(field_);
    row->addWidget(assign_);
    row->addWidget(remove_);
    row->addWidget(reset_);
    row->addStretch(1);
    row->addWidget(resetAll_);
    layout->addLayout(row);
    conflict_->setWordWrap(true);
    conflict_->setProperty("role", "second");
    conflict_->setMinimumHeight(2 * fontMetrics().height() + 4);
    conflict_->setAlignment(Qt::AlignTop);
    layout->addWidget(conflict_);
    assign_->setToolTip(tr("The chosen command gets the key in the field."));
    remove_->setToolTip(tr("The chosen command is run from menus and the palette only."));
    reset_->setToolTip(tr("The chosen command gets back the keys that the studio brings."));
    resetAll_->setToolTip(tr("All commands get back the keys that the studio brings."));
    for (QPushButton* button : {assign_, remove_, reset_, resetAll_})
        button->setAutoDefault(false);

    connect(search_, &QLineEdit::textChanged, this, &KeyEditor::fill);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
        field_->setKey({});
        showChosen();
    });
    connect(field_, &KeyField::keyChanged, this, &KeyEditor::showChosen);
    connect(assign_, &QPushButton::clicked, this, &KeyEditor::assign);
    connect(remove_, &QPushButton::clicked, this, [this] { rebind(commands_, chosen(), {}); });
    connect(reset_, &QPushButton::clicked, this, [this] { resetKeys(commands_, chosen()); });
    connect(resetAll_, &QPushButton::clicked, this, [this] { resetKeys(commands_); });
    connect(&commands_, &CommandTable::renamed, this, &KeyEditor::fill, Qt::QueuedConnection);
    fill();
}

QString KeyEditor::chosen() const {
    const QTreeWidgetItem* item = tree_->currentItem();
    return item ? item->data(0, Qt::UserRole).toString() : QString();
}

void KeyEditor::chooseCommand(const QString& id) {
    for (int row = 0; row < tree_->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = tree_->topLevelItem(row);
        if (item->data(0, Qt::UserRole).toString() == id) tree_->setCurrentItem(item);
    }
}

void KeyEditor::fill() {
    const QString before = chosen();
    const QKeySequence pressed = field_->key();
    const QString typed = search_->text();
    tree_->clear();
    for (const Command& command : commands_.commands()) {
        const bool found =
            fuzzyMatch(typed, nameOf(command)) ||
            (!typed.isEmpty() && command.keysText().contains(typed, Qt::CaseInsensitive));
        if (!found) continue;
        auto* item = new QTreeWidgetItem(
            tree_, {command.plainText(), command.plainMenu(), command.keysText()});
        item->setData(0, Qt::UserRole, command.id);
        if (command.keys != commands_.defaultKeys(command.id)) {
            QFont own = font();
            own.setBold(true);
            item->setFont(2, own);
            item->setToolTip(2,
                             tr("Your own; the studio brings: %1")
                                 .arg(QKeySequence::listToString(commands_.defaultKeys(command.id),
                                                                 QKeySequence::NativeText)));
        }
    }
    chooseCommand(before);
    if (chosen() == before) field_->setKey(pressed);
    showChosen();
}

void KeyEditor::showChosen() {
    const Command* command = commands_.find(chosen());
    const QKeySequence key = field_->key();
    field_->setEnabled(command != nullptr);
    remove_->setEnabled(command != nullptr && !command->keys.isEmpty());
    reset_->setEnabled(command != nullptr && command->keys != commands_.defaultKeys(command->id));
    assign_->setText(tr("Assign"));
    assign_->setEnabled(false);
    if (command == nullptr) {
        conflict_->setText(tr("Choose a command to give it another key."));
        return;
    }
    if (key.isEmpty()) {
        conflict_->setText(tr("Press the new key for “%1” in the field.").arg(nameOf(*command)));
        return;
    }
    const QString written = key.toString(QKeySequence::NativeText);
    if (command->keys.contains(key)) {
        conflict_->setText(tr("%1 is its key already.").arg(written));
        return;
    }
    assign_->setEnabled(true);
    QStringList others;
    for (const Command* other : conflictsOf(commands_, command->id, key))
        others.append(nameOf(*other));
    if (others.isEmpty()) {
        conflict_->setText(tr("%1 is free.").arg(written));
        return;
    }
    assign_->setText(tr("Take it over"));
    conflict_->setText(tr("%1 is the key of %2. Taking it over leaves that command without it.")
                           .arg(written, others.join(tr(" and "))));
}

void KeyEditor::assign() {
    const QString id = chosen();
    const QKeySequence key = field_->key();
    const Command* command = commands_.find(id);
    if (command == nullptr || key.isEmpty()) return;
    for (const Command* other : conflictsOf(commands_, id, key)) {
        QList<QKeySequence> left = other->keys;
        left.removeAll(key);
        rebind(commands_, other->id, left);
    }
    QList<QKeySequence> keys = command->keys;
    keys.prepend(key);
    rebind(commands_, id, keys);
    field_->setKey({});
}

}  // namespace kumite::studio
