// The desktop's wish for dark windows, told by a portal on a message bus of the test's own.

#include <gtest/gtest.h>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include "studio/app/system_theme.h"
#include "studio/app/theme.h"

namespace kumite::studio {

/// What a desktop's portal answers to "Read".
class MadePortal : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.portal.Settings")

public:
    uint scheme = 1;

public Q_SLOTS:
    QDBusVariant Read(const QString& group, const QString& key) {
        asked = group + QLatin1Char(' ') + key;
        return QDBusVariant(QVariant::fromValue(QDBusVariant(scheme)));
    }

public:
    QString asked;
};

namespace {

TEST(SystemTheme, WithoutAPortalTheDesktopHasNoWish) {
    const SystemTheme theme(QDBusConnection(QStringLiteral("not there")));
    EXPECT_FALSE(theme.isDark().has_value());
}

TEST(SystemTheme, FollowsThePortal) {
    const QString daemon = QStandardPaths::findExecutable("dbus-daemon");
    if (daemon.isEmpty()) GTEST_SKIP() << "there is no dbus-daemon";
    QProcess bus;
    bus.start(daemon, {"--session", "--nofork", "--print-address"});
    ASSERT_TRUE(bus.waitForStarted());
    ASSERT_TRUE(bus.waitForReadyRead());
    const QString address = QString::fromUtf8(bus.readLine()).trimmed();
    {
        QDBusConnection desktop = QDBusConnection::connectToBus(address, "desktop");
        ASSERT_TRUE(desktop.isConnected());
        MadePortal portal;
        ASSERT_TRUE(desktop.registerService("org.freedesktop.portal.Desktop"));
        ASSERT_TRUE(desktop.registerObject("/org/freedesktop/portal/desktop", &portal,
                                           QDBusConnection::ExportAllSlots));
        SystemTheme theme(QDBusConnection::connectToBus(address, "studio"));
        EXPECT_TRUE(QTest::qWaitFor([&] { return theme.isDark() == std::optional(true); }));
        EXPECT_EQ(portal.asked, "org.freedesktop.appearance color-scheme");
        const auto tell = [&](const QString& key, uint value) {
            QDBusMessage signal =
                QDBusMessage::createSignal("/org/freedesktop/portal/desktop",
                                           "org.freedesktop.portal.Settings", "SettingChanged");
            signal << QString("org.freedesktop.appearance") << key
                   << QVariant::fromValue(QDBusVariant(value));
            desktop.send(signal);
        };
        tell("color-scheme", 2);
        EXPECT_TRUE(QTest::qWaitFor([&] { return theme.isDark() == std::optional(false); }));
        tell("contrast", 1);
        tell("color-scheme", 0);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !theme.isDark().has_value(); }));
    }
    QDBusConnection::disconnectFromBus("studio");
    QDBusConnection::disconnectFromBus("desktop");
    bus.kill();
    bus.waitForFinished();
}

TEST(SystemTheme, DecidesWhereTheUserWantsNoOther) {
    const bool before = coloursFor(QGuiApplication::palette()).dark;
    setSystemDark(true);
    applyTheme(ThemeChoice::System);
    EXPECT_TRUE(coloursFor(QGuiApplication::palette()).dark);
    setSystemDark(false);
    applyTheme(ThemeChoice::System);
    EXPECT_FALSE(coloursFor(QGuiApplication::palette()).dark);
    applyTheme(ThemeChoice::Dark);
    EXPECT_TRUE(coloursFor(QGuiApplication::palette()).dark);
    setSystemDark(std::nullopt);
    applyTheme(before ? ThemeChoice::Dark : ThemeChoice::Light);
}

}  // namespace
}  // namespace kumite::studio

#include "system_theme_test.moc"
