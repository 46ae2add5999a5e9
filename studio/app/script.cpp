#include "studio/app/script.h"

#include <QAction>
#include <QFile>

#include <algorithm>
#include <cstdio>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/main_window.h"
#include "studio/app/picture.h"

namespace kumite::studio {

namespace {

bool isCommand(MainWindow& window, const QString& id) {
    return std::any_of(window.commands().commands().begin(), window.commands().commands().end(),
                       [&](const Command& command) { return command.id == id; });
}

bool runLine(MainWindow& window, const QStringList& words) {
    const QString& verb = words.front();
    const double number = words.value(1).toDouble();
    if (verb == QLatin1String("time")) {
        window.session().transport().setPlayhead(number);
    } else if (verb == QLatin1String("take")) {
        window.session().setTake(static_cast<int>(number) - 1);
    } else if (verb == QLatin1String("wait")) {
        letWork(static_cast<int>(number));
    } else if (verb == QLatin1String("import")) {
        window.files().showImportDialog(words.mid(1));
    } else if (verb == QLatin1String("save")) {
        return window.files().saveTo(words.value(1));
    } else if (isCommand(window, verb)) {
        window.commands().run(verb);
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool runScript(MainWindow& window, const QString& file) {
    QFile script(file);
    if (!script.open(QIODevice::ReadOnly)) {
        std::fprintf(stderr, "%s: cannot be read.\n", qPrintable(file));
        return false;
    }
    waitWhileBusy(window);
    while (!script.atEnd()) {
        const QString line = QString::fromUtf8(script.readLine()).trimmed();
        if (line.isEmpty()) continue;
        if (!runLine(window, line.split(QLatin1Char(' '), Qt::SkipEmptyParts))) {
            std::fprintf(stderr, "%s: cannot run \"%s\".\n", qPrintable(file), qPrintable(line));
            return false;
        }
        std::printf("%s\n", qPrintable(line));
        std::fflush(stdout);
    }
    return true;
}

}  // namespace kumite::studio
