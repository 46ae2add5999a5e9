#include <QApplication>
#include <QCommandLineParser>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/base/text.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/icons.h"
#include "studio/app/main_window.h"
#include "studio/app/opening.h"
#include "studio/app/picture.h"
#include "studio/app/recovery.h"

namespace {

using namespace kumite;
using namespace kumite::studio;

/// What the command line asks for.
struct Wishes {
    QStringList files;
    QString picture;
    QSize size;
    std::optional<ThemeChoice> theme;
    std::optional<double> time;
    std::optional<double> rate;
    QString command;
};

[[noreturn]] void refuse(const QString& sentence) {
    std::fprintf(stderr, "kumite-studio: %s\n", qPrintable(sentence));
    std::exit(2);
}

std::optional<double> numberOption(const QCommandLineParser& parser, const QString& name) {
    if (!parser.isSet(name)) return std::nullopt;
    const auto number = parseNumber(parser.value(name).toStdString());
    if (!number) refuse(QStringLiteral("--%1 needs a number.").arg(name));
    return number;
}

Wishes readCommandLine(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("The Kumite studio. FILES: one .kumite project, or one or two recordings."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("files", "what to open", "[FILES…]");
    parser.addOptions(
        {{"picture", "Write a picture of the window to OUT.png and exit.", "OUT.png"},
         {"size", "Size of the window, such as 1280x800.", "WxH"},
         {"theme", "dark or light; otherwise as the system.", "THEME"},
         {"time", "Moment that is shown first, seconds.", "S"},
         {"rate", "Frame rate of the recordings, where their headers are wrong.", "HZ"},
         {"run", "Run a command once everything is open, such as help.keys.", "COMMAND"}});
    parser.process(application);
    Wishes wishes;
    wishes.files = parser.positionalArguments();
    wishes.picture = parser.value("picture");
    wishes.time = numberOption(parser, "time");
    wishes.rate = numberOption(parser, "rate");
    wishes.command = parser.value("run");
    const QString theme = parser.value("theme");
    if (theme == "dark")
        wishes.theme = ThemeChoice::Dark;
    else if (theme == "light")
        wishes.theme = ThemeChoice::Light;
    else if (!theme.isEmpty())
        refuse("--theme is dark or light.");
    if (parser.isSet("size")) {
        const QStringList parts = parser.value("size").split('x');
        if (parts.size() == 2) wishes.size = QSize(parts[0].toInt(), parts[1].toInt());
        if (wishes.size.isEmpty()) refuse("--size needs two numbers, such as 1280x800.");
    }
    return wishes;
}

void openFiles(MainWindow& window, const Wishes& wishes) {
    if (wishes.rate && !wishes.files.isEmpty() && !isProjectFile(wishes.files.front())) {
        TakeRequest request = requestFor(wishes.files);
        request.rate = wishes.rate;
        window.files().openBout(request, true);
    } else {
        window.files().open(wishes.files);
    }
}

void offerRecovery(MainWindow& window, Recovery& recovery) {
    const auto copy = Recovery::leftBehind();
    if (!copy) return;
    const QString edits =
        copy->edits == 1 ? MainWindow::tr("1 edit") : MainWindow::tr("%1 edits").arg(copy->edits);
    QMessageBox box(QMessageBox::Question, MainWindow::tr("Recovery"),
                    MainWindow::tr("Kumite closed unexpectedly. Recover %1 with %2 from %3?")
                        .arg(copy->name, edits, copy->time.toString("hh:mm")),
                    QMessageBox::NoButton, &window);
    QAbstractButton* recover = box.addButton(MainWindow::tr("Recover"), QMessageBox::AcceptRole);
    QAbstractButton* discard =
        box.addButton(MainWindow::tr("Discard"), QMessageBox::DestructiveRole);
    box.addButton(MainWindow::tr("Later"), QMessageBox::RejectRole);
    box.exec();
    if (box.clickedButton() == recover) {
        // The old copy goes only once this run has one of its own.
        QObject::connect(&window.files(), &FileActions::recovered, &recovery,
                         [&recovery, copy = *copy] {
                             recovery.writeCopy();
                             Recovery::discard(copy);
                         });
        window.files().openRecovered(copy->file, copy->original);
    }
    if (box.clickedButton() == discard) Recovery::discard(*copy);
}

}  // namespace

int main(int argc, char** argv) {
    // VTK 9.1 finds its OpenGL functions through GLX only.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && !qEnvironmentVariableIsEmpty("DISPLAY")) {
        qputenv("QT_QPA_PLATFORM", "xcb");
    }
    MainWindow::prepareGraphics();
    QApplication application(argc, argv);
    QApplication::setOrganizationName("kumite");
    QApplication::setApplicationName("kumite-studio");
    QApplication::setApplicationVersion(KUMITE_VERSION);
    QApplication::setWindowIcon(applicationIcon());
    const Wishes wishes = readCommandLine(application);
    const bool picture = !wishes.picture.isEmpty();
    if (picture) {
        // Pictures must not depend on what the user did before, nor change it.
        QApplication::setApplicationName("kumite-studio-picture");
        QSettings().clear();
    }
    applyTheme(wishes.theme.value_or(Preferences().values().theme));
    MainWindow window;
    if (wishes.theme) window.setTheme(*wishes.theme);
    if (!wishes.command.isEmpty() && window.commands().find(wishes.command) == nullptr) {
        refuse(QStringLiteral("there is no command %1.").arg(wishes.command));
    }
    if (!wishes.size.isEmpty()) window.resize(wishes.size);
    window.show();
    openFiles(window, wishes);
    if (!wishes.command.isEmpty()) {
        waitWhileBusy(window);
        window.commands().run(wishes.command);
    }
    if (picture) return takePicture(window, wishes.picture, wishes.time) ? 0 : 1;
    if (wishes.time) {
        waitWhileBusy(window);
        window.session().transport().setPlayhead(*wishes.time);
    }
    Recovery recovery(window.session());
    const auto setInterval = [&] {
        recovery.setInterval(window.preferences().values().autosaveSeconds);
    };
    setInterval();
    QObject::connect(&window.preferences(), &Preferences::changed, &recovery, setInterval);
    if (wishes.files.isEmpty()) offerRecovery(window, recovery);
    return QApplication::exec();
}
