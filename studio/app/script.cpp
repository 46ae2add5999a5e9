#include "studio/app/script.h"

#include <QFile>

#include <cstdio>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/loop_watch.h"
#include "studio/app/main_window.h"
#include "studio/app/picture.h"
#include "studio/app/questions.h"
#include "studio/app/recovery.h"
#include "studio/workspaces/label/label_exchange.h"

namespace kumite::studio {

namespace {

bool runLine(MainWindow& window, const QStringList& words) {
    const QString& verb = words.front();
    const double number = words.value(1).toDouble();
    if (verb == QLatin1String("time")) {
        window.session().transport().setPlayhead(number);
    } else if (verb == QLatin1String("take")) {
        window.session().setTake(static_cast<int>(number) - 1);
    } else if (verb == QLatin1String("wait")) {
        letWork(static_cast<int>(number));
    } else if (verb == QLatin1String("idle")) {
        waitWhileBusy(window);
    } else if (verb == QLatin1String("import")) {
        window.files().showImportDialog(words.mid(1));
    } else if (verb == QLatin1String("compare")) {
        window.findChild<LabelExchange*>()->compareWith(words.value(1));
    } else if (verb == QLatin1String("save")) {
        return window.files().saveTo(words.value(1));
    } else if (verb == QLatin1String("recover")) {
        const auto copies = Recovery::leftBehind();
        if (copies.empty()) return false;
        window.files().openRecovered(copies.front());
        waitWhileBusy(window);
    } else if (const Command* command = window.commands().find(verb)) {
        if (!window.commands().isEnabled(*command))
            tell(QStringLiteral("\"%1\" cannot be run now.").arg(verb));
        window.commands().run(verb);
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool runScript(MainWindow& window, const QStringList& lines, LoopWatch* watch) {
    if (!lines.isEmpty()) waitWhileBusy(window);
    for (const QString& line : lines) {
        if (watch != nullptr) watch->note(line);
        const QStringList words = line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        if (words.isEmpty() || !runLine(window, words)) {
            tell(QStringLiteral("cannot run \"%1\".").arg(line));
            return false;
        }
        std::printf("%s\n", qPrintable(line));
        std::fflush(stdout);
    }
    return true;
}

std::optional<QStringList> scriptLines(const QString& file) {
    QFile script(file);
    if (!script.open(QIODevice::ReadOnly)) return std::nullopt;
    QStringList lines;
    while (!script.atEnd()) {
        const QString line = QString::fromUtf8(script.readLine()).trimmed();
        if (!line.isEmpty()) lines.append(line);
    }
    return lines;
}

}  // namespace kumite::studio
