#include "studio/app/key_bindings.h"

#include <QSettings>
#include <QWidget>

#include <algorithm>

#include "studio/app/commands.h"

namespace kumite::studio {

namespace {

QString settingOf(const QString& id) {
    return QStringLiteral("keys/") + id;
}

QStringList textsOf(const QList<QKeySequence>& keys) {
    QStringList texts;
    for (const QKeySequence& key : keys)
        texts.append(key.toString(QKeySequence::PortableText));
    return texts;
}

bool meet(const Command& a, const Command& b) {
    if (!a.workspace.isEmpty() && !b.workspace.isEmpty()) {
        const QStringList both = a.workspace.split(QLatin1Char(' '));
        const bool shared = std::any_of(both.begin(), both.end(),
                                        [&](const QString& each) { return b.isOf(each); });
        if (!shared) return false;
    }
    if (a.scopes.isEmpty() || b.scopes.isEmpty()) return true;
    return std::any_of(a.scopes.begin(), a.scopes.end(), [&](const QWidget* one) {
        return std::any_of(b.scopes.begin(), b.scopes.end(), [&](const QWidget* other) {
            return one == other || one->isAncestorOf(other) || other->isAncestorOf(one);
        });
    });
}

/// Takes a command's keys away from all others that would hear them.
void takeFromOthers(CommandTable& commands, const QString& id) {
    const QList<QKeySequence> keys = commands.find(id)->keys;
    for (const QKeySequence& key : keys) {
        for (const Command* other : conflictsOf(commands, id, key)) {
            QList<QKeySequence> left = other->keys;
            left.removeAll(key);
            rebind(commands, other->id, left);
        }
    }
}

}  // namespace

void loadKeys(CommandTable& commands) {
    const QSettings settings;
    std::vector<QString> own;
    for (const Command& command : commands.commands()) {
        if (settings.contains(settingOf(command.id))) own.push_back(command.id);
    }
    for (const QString& id : own) {
        QList<QKeySequence> keys;
        for (const QString& text : settings.value(settingOf(id)).toStringList()) {
            const QKeySequence key = QKeySequence::fromString(text, QKeySequence::PortableText);
            if (!key.isEmpty()) keys.append(key);
        }
        commands.setKeys(id, keys);
    }
    for (const QString& id : own) {
        const QList<QKeySequence> keys = commands.find(id)->keys;
        for (const QKeySequence& key : keys) {
            for (const Command* other : conflictsOf(commands, id, key)) {
                if (std::find(own.begin(), own.end(), other->id) != own.end()) continue;
                QList<QKeySequence> left = other->keys;
                left.removeAll(key);
                commands.setKeys(other->id, left);
            }
        }
    }
}

void rebind(CommandTable& commands, const QString& id, const QList<QKeySequence>& keys) {
    commands.setKeys(id, keys);
    QSettings settings;
    if (keys == commands.defaultKeys(id)) {
        settings.remove(settingOf(id));
    } else {
        settings.setValue(settingOf(id), textsOf(keys));
    }
}

void resetKeys(CommandTable& commands, const QString& id) {
    if (!id.isEmpty()) {
        rebind(commands, id, commands.defaultKeys(id));
        takeFromOthers(commands, id);
        return;
    }
    for (const Command& command : commands.commands())
        rebind(commands, command.id, commands.defaultKeys(command.id));
    QSettings().remove(QStringLiteral("keys"));
}

std::vector<const Command*> conflictsOf(const CommandTable& commands, const QString& id,
                                        const QKeySequence& key) {
    std::vector<const Command*> found;
    const Command* self = commands.find(id);
    if (self == nullptr) return found;
    for (const Command& other : commands.commands()) {
        if (&other != self && other.keys.contains(key) && meet(*self, other)) {
            found.push_back(&other);
        }
    }
    return found;
}

}  // namespace kumite::studio
