#include "studio/app/commands.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>

#include "studio/app/icons.h"
#include "studio/app/theme.h"

namespace kumite::studio {

CommandTable::CommandTable(QWidget* window) : QObject(window), window_(window) {}

void CommandTable::add(Command command) {
    auto* action = new QAction(command.text, this);
    action->setObjectName(command.id);
    action->setShortcuts(command.keys);
    if (command.checked) action->setCheckable(true);
    if (!command.keys.isEmpty()) {
        QString plain = command.text;
        plain.remove(QLatin1Char('&'));
        plain.remove(QStringLiteral("…"));
        action->setToolTip(QStringLiteral("%1 (%2)").arg(
            plain, command.keys.front().toString(QKeySequence::NativeText)));
    }
    if (command.scopes.isEmpty()) {
        window_->addAction(action);
    } else {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        for (QWidget* scope : command.scopes)
            scope->addAction(action);
    }
    connect(action, &QAction::triggered, this, [this, run = command.run] {
        run();
        refresh();
    });
    commands_.push_back(std::move(command));
    actions_.push_back(action);
}

QAction* CommandTable::action(const QString& id) const {
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        if (commands_[i].id == id) return actions_[i];
    }
    qFatal("no command %s", qPrintable(id));
}

void CommandTable::run(const QString& id) const {
    action(id)->trigger();
}

void CommandTable::refresh() {
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        if (commands_[i].enabled) actions_[i]->setEnabled(commands_[i].enabled());
        if (commands_[i].checked) actions_[i]->setChecked(commands_[i].checked());
    }
}

void CommandTable::refreshIcons() {
    const QColor colour = coloursFor(window_->palette()).text;
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        if (!commands_[i].icon.isEmpty()) {
            actions_[i]->setIcon(lineIcon(commands_[i].icon, colour));
            actions_[i]->setIconVisibleInMenu(false);
        }
    }
}

void CommandTable::fillMenus(QMenuBar* bar) {
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        QString title = commands_[i].menu;
        const bool newGroup = title.startsWith(QLatin1Char('-'));
        if (newGroup) title.remove(0, 1);
        if (title.isEmpty()) continue;
        QMenu* target = menu(title);
        if (target == nullptr) {
            target = bar->addMenu(title);
            menus_.push_back(target);
            connect(target, &QMenu::aboutToShow, this, &CommandTable::refresh);
        } else if (newGroup) {
            target->addSeparator();
        }
        target->addAction(actions_[i]);
    }
}

QMenu* CommandTable::menu(const QString& title) const {
    for (QMenu* menu : menus_) {
        if (menu->title() == title) return menu;
    }
    return nullptr;
}

}  // namespace kumite::studio
