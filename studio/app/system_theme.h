#pragma once

#include <QDBusConnection>
#include <QDBusMessage>
#include <QObject>

#include <optional>

namespace kumite::studio {

/// Whether the desktop asks for dark windows, and when that changes: the setting "color-scheme" of
/// the XDG desktop portal. Desktops without the portal say nothing.
class SystemTheme : public QObject {
    Q_OBJECT

public:
    explicit SystemTheme(QDBusConnection bus, QObject* parent = nullptr);

    /// Nothing: the desktop has no wish, or has not answered yet.
    std::optional<bool> isDark() const { return dark_; }

Q_SIGNALS:
    void changed();

private Q_SLOTS:
    void settingChanged(const QDBusMessage& message);

private:
    void take(const QVariant& value);

    std::optional<bool> dark_;
};

}  // namespace kumite::studio
