#include "studio/app/keys_page.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFile>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPageSize>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/panel_parts.h"
#include "studio/app/questions.h"
#include "studio/help/keys_sheet.h"

namespace kumite::studio {

namespace {

constexpr int kColumnWidth = 286;
constexpr int kMostColumns = 4;
constexpr int kKeysWidth = 100;

/// Only the rows that hold what was typed.
std::vector<KeyGroup> found(const std::vector<KeyGroup>& groups, const QString& typed) {
    std::vector<KeyGroup> left;
    for (const KeyGroup& group : groups) {
        KeyGroup some{group.title, {}};
        for (const KeyGroup::Row& row : group.rows) {
            if (row.text.contains(typed, Qt::CaseInsensitive) ||
                row.keys.contains(typed, Qt::CaseInsensitive) ||
                group.title.contains(typed, Qt::CaseInsensitive)) {
                some.rows.push_back(row);
            }
        }
        if (!some.rows.empty()) left.push_back(std::move(some));
    }
    return left;
}

QWidget* groupBox(const KeyGroup& group, QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* rows = new QGridLayout(box);
    rows->setContentsMargins(0, 0, 0, 12);
    rows->setHorizontalSpacing(12);
    rows->setVerticalSpacing(3);
    auto* title = headingLabel(group.title, box);
    rows->addWidget(title, 0, 0, 1, 2);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        auto* keys = new QLabel(group.rows[i].keys, box);
        auto* text = new QLabel(group.rows[i].text, box);
        text->setProperty("role", "second");
        keys->setFixedWidth(withTextSize(kKeysWidth));
        for (QLabel* label : {keys, text}) {
            label->setWordWrap(true);
            label->setAlignment(Qt::AlignTop);
        }
        rows->addWidget(keys, static_cast<int>(i) + 1, 0);
        rows->addWidget(text, static_cast<int>(i) + 1, 1);
    }
    rows->setColumnStretch(1, 1);
    return box;
}

std::size_t linesOf(const KeyGroup& group) {
    return group.rows.size() + 2;
}

/// The least number of lines in which the groups, in their order, fit into so many columns.
std::size_t columnLength(const std::vector<KeyGroup>& groups, int columns) {
    std::size_t length = 0;
    for (const KeyGroup& group : groups)
        length = std::max(length, linesOf(group));
    for (;; ++length) {
        int needed = 1;
        std::size_t used = 0;
        for (const KeyGroup& group : groups) {
            if (used + linesOf(group) > length) {
                ++needed;
                used = 0;
            }
            used += linesOf(group);
        }
        if (needed <= columns) return length;
    }
}

}  // namespace

std::vector<KeyGroup> keyGroups(const CommandTable& commands, KeysOf which) {
    std::vector<KeyGroup> groups;
    for (const Command& command : commands.commands()) {
        // Those of other workspaces are not in force.
        const bool shown = which == KeysOf::Everything || commands.action(command.id)->isVisible();
        if (command.keys.isEmpty() || !shown) continue;
        const QString title = command.plainMenu();
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const KeyGroup& g) { return g.title == title; });
        if (group == groups.end()) group = groups.insert(groups.end(), KeyGroup{title, {}});
        group->rows.push_back({command.keysText(), command.plainText()});
    }
    groups.push_back({KeysPage::tr("Mouse on the timeline"),
                      {{KeysPage::tr("click, double-click"),
                        KeysPage::tr("select a boundary; remove or restore it")},
                       {KeysPage::tr("× over a boundary"), KeysPage::tr("remove it at once")},
                       {KeysPage::tr("drag a boundary"),
                        KeysPage::tr("move it; Ctrl or Alt: without snapping; Esc: leave it")},
                       {KeysPage::tr("drag elsewhere"), KeysPage::tr("scrub")},
                       {KeysPage::tr("drag a loop end on the ruler"), KeysPage::tr("move it")},
                       {KeysPage::tr("click, double-click an action"),
                        KeysPage::tr("select it; show and loop it")},
                       {KeysPage::tr("right click"), KeysPage::tr("what can be done there")},
                       {KeysPage::tr("wheel, Shift+wheel, middle drag"), KeysPage::tr("scroll")},
                       {KeysPage::tr("Ctrl+wheel"), KeysPage::tr("zoom about the pointer")}}});
    groups.push_back({KeysPage::tr("Mouse in the 3D view"),
                      {{KeysPage::tr("drag"), KeysPage::tr("turn")},
                       {KeysPage::tr("middle or Shift+drag"), KeysPage::tr("move")},
                       {KeysPage::tr("wheel"), KeysPage::tr("zoom about the pointer")},
                       {KeysPage::tr("click a fighter"), KeysPage::tr("make it the active one")},
                       {KeysPage::tr("right click"), KeysPage::tr("what can be done there")},
                       {KeysPage::tr("measuring: click joints"),
                        KeysPage::tr("distance; over a joint: its speed")}}});
    return groups;
}

KeysPage::KeysPage(const CommandTable& commands, QWidget* parent)
    : QDialog(parent),
      commands_(commands),
      search_(new QLineEdit(this)),
      scroll_(new QScrollArea(this)),
      problem_(new QLabel(this)) {
    setWindowTitle(tr("Keys and mouse"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 16, 24, 12);
    layout->setSpacing(12);
    search_->setPlaceholderText(tr("Search keys and commands"));
    search_->setAccessibleName(tr("Search keys and commands"));
    search_->setToolTip(tr("Shows the lines that hold these letters"));
    search_->setClearButtonEnabled(true);
    layout->addWidget(search_);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setWidgetResizable(true);
    scroll_->setAccessibleName(windowTitle());
    layout->addWidget(scroll_, 1);
    problem_->hide();
    layout->addWidget(problem_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* print = buttons->addButton(tr("Print…"), QDialogButtonBox::ActionRole);
    auto* pdf = buttons->addButton(tr("Save as PDF…"), QDialogButtonBox::ActionRole);
    auto* remap = buttons->addButton(tr("Change keys…"), QDialogButtonBox::ActionRole);
    print->setToolTip(tr("The keys of all workspaces, on paper. (Ctrl+P)"));
    print->setShortcut(QKeySequence::Print);
    pdf->setToolTip(tr("The keys of all workspaces, as a file."));
    remap->setToolTip(tr("Gives commands other keys, in the preferences."));
    for (QPushButton* button : {print, pdf, remap})
        button->setAutoDefault(false);
    connect(print, &QPushButton::clicked, this, &KeysPage::askForPrinter);
    connect(pdf, &QPushButton::clicked, this, &KeysPage::askForFile);
    connect(remap, &QPushButton::clicked, this, &KeysPage::remapWanted);
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close this page (Esc)"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    connect(search_, &QLineEdit::textChanged, this, &KeysPage::fill);
    connect(&commands_, &CommandTable::renamed, this, &KeysPage::fill, Qt::QueuedConnection);
    fill();
    const QSize screen = QGuiApplication::primaryScreen()->availableSize();
    resize(QSize(1220, 760).boundedTo(screen - QSize(40, 60)));
    search_->setFocus();
}

void KeysPage::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    if (columnCount() != columns_) fill();
}

int KeysPage::columnCount() const {
    return std::clamp((width() - 60) / withTextSize(kColumnWidth), 1, kMostColumns);
}

void KeysPage::fill() {
    columns_ = columnCount();
    auto* content = new QWidget(scroll_);
    auto* columns = new QHBoxLayout(content);
    columns->setContentsMargins(0, 0, 8, 0);
    columns->setSpacing(24);
    const auto groups = found(keyGroups(commands_), search_->text().trimmed());
    const std::size_t length = columnLength(groups, columns_);
    QVBoxLayout* column = nullptr;
    std::size_t used = 0;
    for (const KeyGroup& group : groups) {
        if (column == nullptr || used + linesOf(group) > length) {
            if (column != nullptr) column->addStretch(1);
            column = new QVBoxLayout;
            column->setSpacing(0);
            columns->addLayout(column, 1);
            used = 0;
        }
        column->addWidget(groupBox(group, content));
        used += linesOf(group);
    }
    // Few answers to a search are no wider than all.
    while (column != nullptr && columns->count() < columns_)
        columns->addStretch(1);
    if (column != nullptr) {
        column->addStretch(1);
    } else {
        auto* none = new QLabel(tr("No key and no command holds these letters."), content);
        none->setProperty("role", "second");
        columns->addWidget(none, 0, Qt::AlignTop);
    }
    scroll_->setWidget(content);
}

bool KeysPage::saveTo(const QString& pdf) const {
    QFile file(pdf);
    if (!file.open(QIODevice::WriteOnly)) return false;
    QPdfWriter writer(&file);
    writer.setTitle(windowTitle());
    writer.setPageSize(QPageSize(QPageSize::A4));
    if (!paintKeysSheet(keyGroups(commands_, KeysOf::Everything), writer)) return false;
    return file.error() == QFile::NoError;
}

bool KeysPage::printTo(QPrinter& printer) const {
    printer.setDocName(windowTitle());
    return paintKeysSheet(keyGroups(commands_, KeysOf::Everything), printer);
}

void KeysPage::askForPrinter() {
    if (!isAttended()) return tell(tr("Nobody is here to choose a printer."));
    QPrinter printer(QPrinter::HighResolution);
    QPrintDialog dialog(&printer, this);
    dialog.setWindowTitle(tr("Print the sheet of keys"));
    dialog.setOption(QAbstractPrintDialog::PrintPageRange, false);
    if (dialog.exec() != QDialog::Accepted) return;
    problem_->setVisible(!printTo(printer));
    problem_->setText(tr("%1 does not take the sheet.").arg(printer.printerName()));
}

void KeysPage::askForFile() {
    const QString path = fileToSave(this, tr("Save the sheet of keys"),
                                    QStringLiteral("kumite-keys.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty()) return;
    problem_->setVisible(!saveTo(path));
    problem_->setText(tr("%1 cannot be written there.").arg(path));
}

}  // namespace kumite::studio
