#include "studio/app/commands.h"

#include <QAbstractScrollArea>
#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>

#include <algorithm>
#include <utility>

#include "studio/app/icons.h"
#include "studio/app/language.h"
#include "studio/app/theme.h"

namespace kumite::studio {

QString Command::plainText() const {
    return withoutMnemonic(text);
}

QString Command::plainMenu() const {
    return withoutMnemonic(menu.startsWith(QLatin1Char('-')) ? menu.mid(1) : menu);
}

QString Command::keysText() const {
    QStringList names;
    for (const QKeySequence& key : keys)
        names.append(key.toString(QKeySequence::NativeText));
    return names.join(QStringLiteral(" · "));
}

bool Command::isOf(const QString& id) const {
    return workspace.isEmpty() || workspace.split(QLatin1Char(' ')).contains(id);
}

CommandTable::CommandTable(QWidget* window) : QObject(window), window_(window) {}

void CommandTable::add(Command command) {
    if (command.workspace.isEmpty()) command.workspace = adding_;
    auto* action = new QAction(this);
    action->setObjectName(command.id);
    if (command.checked) action->setCheckable(true);
    action->setAutoRepeat(command.repeats);
    if (command.scopes.isEmpty()) {
        window_->addAction(action);
    } else {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        for (QWidget* scope : command.scopes)
            scope->addAction(action);
    }
    connect(action, &QAction::triggered, this, [this, id = command.id, run = command.run] {
        Q_EMIT running(id);
        run();
        refresh();
    });
    defaultKeys_.push_back(command.keys);
    commands_.push_back(std::move(command));
    actions_.push_back(action);
    describe(commands_.size() - 1);
}

void CommandTable::addFor(const QString& workspaces, const std::function<void()>& addAll) {
    const QString before = std::exchange(adding_, workspaces);
    addAll();
    adding_ = before;
}

void CommandTable::showWorkspace(const QString& workspace) {
    workspace_ = workspace;
    refresh();
}

void CommandTable::describe(std::size_t index) {
    const Command& command = commands_[index];
    QAction* action = actions_[index];
    action->setText(command.text);
    action->setShortcuts(command.keys);
    action->setShortcutVisibleInContextMenu(true);
    action->setToolTip(withKey(command.plainText().remove(QStringLiteral("…")), command.id));
}

std::size_t CommandTable::indexOf(const QString& id) const {
    const auto found = std::find_if(commands_.begin(), commands_.end(),
                                    [&](const Command& each) { return each.id == id; });
    return static_cast<std::size_t>(found - commands_.begin());
}

const Command* CommandTable::find(const QString& id) const {
    const std::size_t index = indexOf(id);
    return index < commands_.size() ? &commands_[index] : nullptr;
}

QAction* CommandTable::action(const QString& id) const {
    const std::size_t index = indexOf(id);
    if (index == commands_.size()) qFatal("no command %s", qPrintable(id));
    return actions_[index];
}

void CommandTable::run(const QString& id) const {
    action(id)->trigger();
}

bool CommandTable::isEnabled(const Command& command) const {
    return command.isOf(workspace_) && (!command.enabled || command.enabled());
}

const QList<QKeySequence>& CommandTable::defaultKeys(const QString& id) const {
    return defaultKeys_.at(indexOf(id));
}

void CommandTable::setKeys(const QString& id, const QList<QKeySequence>& keys) {
    const std::size_t index = indexOf(id);
    if (commands_.at(index).keys == keys) return;
    commands_[index].keys = keys;
    describe(index);
    Q_EMIT renamed();
}

void CommandTable::setDefaultKeys(const QString& id, const QList<QKeySequence>& keys) {
    const std::size_t index = indexOf(id);
    const bool asBrought = commands_.at(index).keys == defaultKeys_[index];
    defaultKeys_[index] = keys;
    if (asBrought) setKeys(id, keys);
}

void CommandTable::setText(const QString& id, const QString& text) {
    const std::size_t index = indexOf(id);
    if (commands_.at(index).text == text) return;
    commands_[index].text = text;
    describe(index);
    Q_EMIT renamed();
}

void CommandTable::setWords(const QString& id, const QString& words) {
    commands_.at(indexOf(id)).words = words;
}

QString CommandTable::withKey(const QString& tip, const QString& id) const {
    const QList<QKeySequence>& keys = commands_.at(indexOf(id)).keys;
    if (keys.isEmpty()) return tip;
    return QStringLiteral("%1 (%2)").arg(tip, keys.front().toString(QKeySequence::NativeText));
}

void CommandTable::tellKey(QWidget* widget, const QString& id) {
    widget->setProperty("command", id);
    const auto tell = [this, widget, id, tip = widget->toolTip()] {
        widget->setToolTip(tip.isEmpty() ? action(id)->toolTip() : withKey(tip, id));
    };
    tell();
    connect(this, &CommandTable::renamed, widget, tell);
}

void CommandTable::refresh() {
    for (std::size_t i = 0; i < commands_.size(); ++i) {
        const Command& command = commands_[i];
        actions_[i]->setVisible(command.isOf(workspace_) && (!command.shown || command.shown()));
        actions_[i]->setEnabled(isEnabled(command));
        if (command.checked) actions_[i]->setChecked(command.checked());
    }
    for (QMenu* menu : menus_) {
        const auto entries = menu->actions();
        const bool any = std::any_of(entries.begin(), entries.end(), [](const QAction* entry) {
            return entry->isVisible() && !entry->isSeparator();
        });
        menu->menuAction()->setVisible(any);
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

void CommandTable::popUp(const QStringList& ids, const QPoint& at) {
    refresh();
    auto* menu = new QMenu(window_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const QString& id : ids) {
        if (id == QLatin1String("-")) {
            menu->addSeparator();
        } else {
            menu->addAction(action(id));
        }
    }
    menu->popup(at);
}

void CommandTable::offerMenu(QWidget* widget, const QStringList& ids) {
    widget->setContextMenuPolicy(Qt::CustomContextMenu);
    auto* area = qobject_cast<QAbstractScrollArea*>(widget);
    const QWidget* shown = area ? area->viewport() : widget;
    connect(widget, &QWidget::customContextMenuRequested, this,
            [this, shown, ids](const QPoint& at) { popUp(ids, shown->mapToGlobal(at)); });
}

}  // namespace kumite::studio
