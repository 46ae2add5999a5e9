#include "studio/app/keys_page.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/commands.h"

namespace kumite::studio {

namespace {

struct Row {
    QString keys;
    QString text;
};

struct Group {
    QString title;
    std::vector<Row> rows;
};

QString keysText(const Command& command) {
    QStringList names;
    for (const QKeySequence& key : command.keys)
        names.append(key.toString(QKeySequence::NativeText));
    return names.join(QStringLiteral(", "));
}

std::vector<Group> groupsOf(const CommandTable& commands) {
    std::vector<Group> groups;
    for (const Command& command : commands.commands()) {
        if (command.keys.isEmpty()) continue;
        QString title = command.menu;
        title.remove(QLatin1Char('-')).remove(QLatin1Char('&'));
        QString text = command.text;
        text.remove(QLatin1Char('&'));
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& g) { return g.title == title; });
        if (group == groups.end()) group = groups.insert(groups.end(), Group{title, {}});
        group->rows.push_back({keysText(command), text});
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

}  // namespace

KeysPage::KeysPage(const CommandTable& commands, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Keys and mouse"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(24, 20, 24, 20);
    grid->setHorizontalSpacing(32);
    grid->setVerticalSpacing(12);
    const auto groups = groupsOf(commands);
    std::size_t lines = 0;
    for (const Group& group : groups)
        lines += group.rows.size() + 2;
    QVBoxLayout* column = nullptr;
    std::size_t used = 0;
    int columns = 0;
    for (const Group& group : groups) {
        // Three columns of about equal length.
        if (column == nullptr || (used + group.rows.size() / 2 > lines / 3 && columns < 3)) {
            column = new QVBoxLayout;
            column->setSpacing(4);
            grid->addLayout(column, 0, columns++, Qt::AlignTop);
            used = 0;
        }
        if (used > 0) column->addSpacing(12);
        auto* title = new QLabel(group.title, this);
        title->setProperty("role", "heading");
        column->addWidget(title);
        auto* rows = new QGridLayout;
        rows->setHorizontalSpacing(12);
        rows->setVerticalSpacing(3);
        for (std::size_t i = 0; i < group.rows.size(); ++i) {
            auto* keys = new QLabel(group.rows[i].keys, this);
            auto* text = new QLabel(group.rows[i].text, this);
            text->setProperty("role", "second");
            rows->addWidget(keys, static_cast<int>(i), 0);
            rows->addWidget(text, static_cast<int>(i), 1);
        }
        rows->setColumnMinimumWidth(0, 110);
        rows->setColumnStretch(1, 1);
        column->addLayout(rows);
        used += group.rows.size() + 2;
    }
}

}  // namespace kumite::studio
