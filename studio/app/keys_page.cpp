#include "studio/app/keys_page.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPageSize>
#include <QPdfWriter>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTextDocument>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/commands.h"

namespace kumite::studio {

namespace {

constexpr int kColumns = 3;

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
    auto* title = new QLabel(group.title, box);
    title->setProperty("role", "heading");
    rows->addWidget(title, 0, 0, 1, 2);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        auto* keys = new QLabel(group.rows[i].keys, box);
        auto* text = new QLabel(group.rows[i].text, box);
        text->setProperty("role", "second");
        rows->addWidget(keys, static_cast<int>(i) + 1, 0);
        rows->addWidget(text, static_cast<int>(i) + 1, 1);
    }
    rows->setColumnMinimumWidth(0, 110);
    rows->setColumnStretch(1, 1);
    return box;
}

QString htmlOf(const std::vector<KeyGroup>& groups) {
    QString html = QStringLiteral("<h2>%1</h2>").arg(KeysPage::tr("Kumite: keys and mouse"));
    for (const KeyGroup& group : groups) {
        html +=
            QStringLiteral("<h4>%1</h4><table cellspacing=\"3\">").arg(group.title.toHtmlEscaped());
        for (const KeyGroup::Row& row : group.rows) {
            html += QStringLiteral("<tr><td width=\"190\"><b>%1</b></td><td>%2</td></tr>")
                        .arg(row.keys.toHtmlEscaped(), row.text.toHtmlEscaped());
        }
        html += QStringLiteral("</table>");
    }
    return html;
}

}  // namespace

std::vector<KeyGroup> keyGroups(const CommandTable& commands) {
    std::vector<KeyGroup> groups;
    for (const Command& command : commands.commands()) {
        // Those of other workspaces are not in force.
        const bool shown = commands.action(command.id)->isVisible();
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
                       {KeysPage::tr("wheel, Shift+wheel, middle drag"), KeysPage::tr("scroll")},
                       {KeysPage::tr("Ctrl+wheel"), KeysPage::tr("zoom about the pointer")}}});
    groups.push_back({KeysPage::tr("Mouse in the 3D view"),
                      {{KeysPage::tr("drag"), KeysPage::tr("turn")},
                       {KeysPage::tr("middle or Shift+drag"), KeysPage::tr("move")},
                       {KeysPage::tr("wheel"), KeysPage::tr("zoom about the pointer")},
                       {KeysPage::tr("click a fighter"), KeysPage::tr("make it the active one")},
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
    search_->setClearButtonEnabled(true);
    layout->addWidget(search_);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setWidgetResizable(true);
    scroll_->setAccessibleName(windowTitle());
    layout->addWidget(scroll_, 1);
    problem_->hide();
    layout->addWidget(problem_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* pdf = buttons->addButton(tr("Save as PDF…"), QDialogButtonBox::ActionRole);
    auto* remap = buttons->addButton(tr("Change keys…"), QDialogButtonBox::ActionRole);
    pdf->setToolTip(tr("The whole sheet, to be printed."));
    remap->setToolTip(tr("Gives commands other keys, in the preferences."));
    for (QPushButton* button : {pdf, remap})
        button->setAutoDefault(false);
    connect(pdf, &QPushButton::clicked, this, &KeysPage::askForFile);
    connect(remap, &QPushButton::clicked, this, &KeysPage::remapWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    connect(search_, &QLineEdit::textChanged, this, &KeysPage::fill);
    connect(&commands_, &CommandTable::renamed, this, &KeysPage::fill, Qt::QueuedConnection);
    fill();
    // As large as its content where the screen has room for it.
    const QSize content = scroll_->widget()->sizeHint();
    const QSize screen = QGuiApplication::primaryScreen()->availableSize();
    resize(std::min(content.width() + 64, screen.width() - 40),
           std::min(content.height() + 140, screen.height() - 60));
    search_->setFocus();
}

void KeysPage::fill() {
    auto* content = new QWidget(scroll_);
    auto* columns = new QHBoxLayout(content);
    columns->setContentsMargins(0, 0, 8, 0);
    columns->setSpacing(32);
    const auto groups = found(keyGroups(commands_), search_->text().trimmed());
    std::size_t lines = 0;
    for (const KeyGroup& group : groups)
        lines += group.rows.size() + 2;
    // Columns of about equal length.
    QVBoxLayout* column = nullptr;
    std::size_t used = 0;
    for (const KeyGroup& group : groups) {
        const bool full = used + group.rows.size() / 2 > lines / kColumns;
        if (column == nullptr || (full && columns->count() < kColumns)) {
            if (column != nullptr) column->addStretch(1);
            column = new QVBoxLayout;
            column->setSpacing(0);
            columns->addLayout(column);
            used = 0;
        }
        column->addWidget(groupBox(group, content));
        used += group.rows.size() + 2;
    }
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
    QTextDocument sheet;
    sheet.setHtml(htmlOf(keyGroups(commands_)));
    sheet.print(&writer);
    return file.error() == QFile::NoError;
}

void KeysPage::askForFile() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the sheet of keys"), QStringLiteral("kumite-keys.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty()) return;
    problem_->setVisible(!saveTo(path));
    problem_->setText(tr("%1 cannot be written there.").arg(path));
}

}  // namespace kumite::studio
