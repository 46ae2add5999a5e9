#include <QApplication>
#include <QCommandLineParser>
#include <QScopeGuard>
#include <QSettings>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

#include "core/base/text.h"
#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/icons.h"
#include "studio/app/language.h"
#include "studio/app/loop_watch.h"
#include "studio/app/main_window.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/picture.h"
#include "studio/app/questions.h"
#include "studio/app/recovery.h"
#include "studio/app/recovery_dialog.h"
#include "studio/app/script.h"
#include "studio/app/window_keeper.h"

namespace {

using namespace kumite;
using namespace kumite::studio;

/// What the command line asks for.
struct Wishes {
    QStringList files;
    QString picture;
    QStringList script;  ///< lines of one
    QSize size;
    std::optional<ThemeChoice> theme;
    QString language;
    std::optional<double> time;
    std::optional<double> rate;
    bool watch = false;

    /// It runs by itself: nobody answers questions.
    bool alone() const { return !picture.isEmpty() || !script.isEmpty() || watch; }
};

[[noreturn]] void refuse(const QString& sentence) {
    tell(sentence);
    std::exit(2);
}

bool isKnownLanguage(const QString& code) {
    const auto& all = languages();
    return code.isEmpty() || code == QLatin1String("pseudo") ||
           std::any_of(all.begin(), all.end(),
                       [&](const Language& language) { return language.code == code; });
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
         {"language", "de, en, fr, ja, ko or zh_TW; otherwise as chosen, or the system's.", "CODE"},
         {"time", "Moment that is shown first, seconds.", "S"},
         {"rate", "Frame rate of the recordings, where their headers are wrong.", "HZ"},
         {"run", "Run a command once everything is open, such as help.keys; may be given again.",
          "COMMAND"},
         {"watch",
          "Tell on standard error when the window does not answer for more than 50 ms, and the "
          "longest such time at the end. What opening and script would ask is told there, too."},
         {"script", "Run the commands of a file, one a line; see studio/app/script.h.", "FILE"}});
    parser.process(application);
    Wishes wishes;
    wishes.files = parser.positionalArguments();
    wishes.picture = parser.value("picture");
    if (parser.isSet("script")) {
        const auto lines = scriptLines(parser.value("script"));
        if (!lines) refuse(QStringLiteral("%1 cannot be read.").arg(parser.value("script")));
        wishes.script = *lines;
    }
    wishes.script += parser.values("run");
    wishes.watch = parser.isSet("watch");
    wishes.language = parser.value("language");
    if (!isKnownLanguage(wishes.language)) refuse("--language is de, en, fr, ja, ko or zh_TW.");
    wishes.time = numberOption(parser, "time");
    wishes.rate = numberOption(parser, "rate");
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

/// Says on standard error what keeps the window from answering.
std::unique_ptr<LoopWatch> watchLoop(const CommandTable& commands) {
    auto watch = std::make_unique<LoopWatch>();
    QObject::connect(&commands, &CommandTable::running, watch.get(), &LoopWatch::note);
    QObject::connect(watch.get(), &LoopWatch::blocked, watch.get(), [](const LoopGap& gap) {
        std::fprintf(stderr, "no answer for %s\n", qPrintable(gap.text()));
    });
    return watch;
}

void reportWatch(const LoopWatch& watch) {
    std::fprintf(stderr, "longest time without an answer: %s; %zu above %.0f ms\n",
                 qPrintable(watch.longest().text()), watch.gaps().size(), LoopWatch::kBlink);
}

/// Asks what to do with what an unexpected end left behind, if anything is there.
void offerRecovery(MainWindow& window) {
    auto copies = Recovery::leftBehind();
    if (copies.empty()) return;
    if (!isAttended()) {
        tell(QStringLiteral("Unsaved edits of %1 can be recovered: start the studio without "
                            "--watch and --script, or with the script's line \"recover\".")
                 .arg(copies.front().name));
        return;
    }
    auto* dialog = new RecoveryDialog(std::move(copies), &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &RecoveryDialog::recoveryWanted, &window.files(),
                     &FileActions::openRecovered);
    dialog->open();
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
    QApplication::setDesktopFileName("org.kumite.Studio");  // resources/linux
    QApplication::setWindowIcon(applicationIcon());
    const Wishes wishes = readCommandLine(application);
    const bool picture = !wishes.picture.isEmpty();
    if (picture) {
        // Pictures must not depend on what the user did before, nor change it.
        QApplication::setApplicationName("kumite-studio-picture");
        QSettings().clear();
    }
    applyTheme(wishes.theme.value_or(Preferences().values().theme));
    // Pictures are English unless they are asked for otherwise.
    const QString english = QStringLiteral("en");
    useLanguage(!wishes.language.isEmpty() ? wishes.language
                : picture                  ? english
                                           : Preferences().values().language);
    WindowKeeper keeper;
    MainWindow& window = keeper.window();
    if (wishes.theme) window.setTheme(*wishes.theme);
    if (!wishes.size.isEmpty()) window.resize(wishes.size);
    window.show();
    const auto watch = wishes.watch ? watchLoop(window.commands()) : nullptr;
    const auto whenLeft = qScopeGuard([&watch] {
        if (watch) reportWatch(*watch);
    });
    setAttended(!wishes.alone());
    openFiles(window, wishes);
    if (picture) {
        if (!runScript(window, wishes.script, watch.get())) return 1;
        return takePicture(window, wishes.picture, wishes.time) ? 0 : 1;
    }
    keeper.keepCopies();
    if (wishes.time) {
        waitWhileBusy(window);
        window.session().transport().setPlayhead(*wishes.time);
    }
    offerRecovery(window);
    if (!runScript(window, wishes.script, watch.get())) return 1;
    if (!keeper.window().isVisible()) return 0;  // a command has quit already
    setAttended(true);                           // whoever watches works on by hand
    return QApplication::exec();
}
