#include "studio/app/system_theme.h"

#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>

namespace kumite::studio {

namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString kGroup = QStringLiteral("org.freedesktop.appearance");
const QString kKey = QStringLiteral("color-scheme");

}  // namespace

SystemTheme::SystemTheme(QDBusConnection bus, QObject* parent) : QObject(parent) {
    if (!bus.isConnected()) return;
    bus.connect({}, kPath, kInterface, QStringLiteral("SettingChanged"), this,
                SLOT(settingChanged(QDBusMessage)));
    QDBusMessage question =
        QDBusMessage::createMethodCall(kService, kPath, kInterface, QStringLiteral("Read"));
    question << kGroup << kKey;
    // Nothing waits for the answer: a portal that has to be started takes its time.
    auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
        const QDBusPendingReply<QDBusVariant> reply = *answer;
        if (!reply.isError()) take(reply.value().variant());
        answer->deleteLater();
    });
}

void SystemTheme::settingChanged(const QDBusMessage& message) {
    const QVariantList told = message.arguments();
    if (told.size() == 3 && told[0] == kGroup && told[1] == kKey) take(told[2]);
}

void SystemTheme::take(const QVariant& value) {
    QVariant scheme = value;
    // `Read` wraps the value twice.
    while (scheme.metaType() == QMetaType::fromType<QDBusVariant>()) {
        scheme = scheme.value<QDBusVariant>().variant();
    }
    // 0 no preference, 1 dark, 2 light.
    const uint number = scheme.toUInt();
    const auto dark = number == 1   ? std::optional(true)
                      : number == 2 ? std::optional(false)
                                    : std::nullopt;
    if (dark == dark_) return;
    dark_ = dark;
    Q_EMIT changed();
}

}  // namespace kumite::studio
