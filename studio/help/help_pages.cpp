#include "studio/help/help_pages.h"

#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include "core/cli/run.h"
#include "studio/app/commands.h"
#include "studio/app/language.h"

namespace kumite::studio {

namespace {

/// The contents.
constexpr const char* kPages[] = {
    "first_steps", "importing", "segment",      "label", "graph", "bout",    "sequence",
    "keyframe",    "method",    "command_line", "files", "keys",  "changes",
};

const QRegularExpression& keyPattern() {
    static const QRegularExpression pattern(QStringLiteral("\\[`([^`]+)`\\]\\(key:([\\w.]+)\\)"));
    return pattern;
}

const QRegularExpression& tablePattern() {
    static const QRegularExpression pattern(QStringLiteral("<!-- commands: (\\w+) -->"));
    return pattern;
}

/// Puts what `text` gives in the place of every match.
QString replaced(const QString& source, const QRegularExpression& pattern,
                 const std::function<QString(const QRegularExpressionMatch&)>& text) {
    QString result;
    qsizetype from = 0;
    for (auto each = pattern.globalMatch(source); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        result += source.mid(from, match.capturedStart() - from) + text(match);
        from = match.capturedEnd();
    }
    return result + source.mid(from);
}

QString cell(QString text) {
    return text.replace(QLatin1Char('|'), QStringLiteral("\\|"));
}

QString keysCell(const Command& command) {
    QStringList keys;
    for (const QKeySequence& key : command.keys)
        keys.append('`' + key.toString(QKeySequence::NativeText) + '`');
    return keys.join(QLatin1Char(' '));
}

QString tableOf(const QString& workspace, const CommandTable& commands) {
    QString table;
    QString menu;
    for (const Command& command : commands.commands()) {
        const bool everywhere = command.workspace.isEmpty();
        if (workspace == QLatin1String("everywhere") ? !everywhere
                                                     : everywhere || !command.isOf(workspace))
            continue;
        if (table.isEmpty()) table = QStringLiteral("| | |\n| --- | --- |\n");
        if (command.plainMenu() != menu) {
            menu = command.plainMenu();
            table += QStringLiteral("| **%1** | |\n").arg(cell(menu));
        }
        table += QStringLiteral("| %1 | %2 |\n").arg(cell(command.plainText()), keysCell(command));
    }
    return table;
}

/// `kumite COMMAND --help`, or without a command what there is.
QString commandLineHelp(const std::string& command) {
    std::ostringstream text;
    cli::run(command.empty() ? std::vector<std::string>{"--help"}
                             : std::vector<std::string>{command, "--help"},
             text, text);
    return QString::fromStdString(text.str()).trimmed();
}

QString commandLine() {
    const QString general = commandLineHelp({});
    const auto fenced = [](const QString& text) {
        return QStringLiteral("```\n%1\n```\n\n").arg(text);
    };
    QString all = fenced(general);
    // The subcommands are the lines "  name      what it does" below their heading.
    static const QRegularExpression name(QStringLiteral("^  ([a-z]+)  +\\S"),
                                         QRegularExpression::MultilineOption);
    const qsizetype from = general.indexOf(QLatin1String("Subcommands:"));
    for (auto each = name.globalMatch(general, std::max<qsizetype>(from, 0)); each.hasNext();) {
        const QString command = each.next().captured(1);
        all += QStringLiteral("## kumite %1\n\n").arg(command) +
               fenced(commandLineHelp(command.toStdString()));
    }
    return all;
}

/// What a heading is linked to by: "Expected accuracy" by "expected-accuracy".
QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar& c : heading.trimmed().toLower()) {
        if (c.isLetterOrNumber() || c == QLatin1Char('-') || c == QLatin1Char('_')) anchor += c;
        if (c.isSpace()) anchor += QLatin1Char('-');
    }
    return anchor;
}

QStringList anchorsOf(const QString& source) {
    QStringList anchors;
    for (const QString& line : source.split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1Char('#')))
            anchors.append(anchorOf(line.mid(line.indexOf(QLatin1Char(' ')))));
    }
    return anchors;
}

std::optional<QString> sourceOf(const QString& path) {
    QFile file(QStringLiteral(":/help/%1.md").arg(path));
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    return QString::fromUtf8(file.readAll());
}

HelpPage readPage(const QString& id, const QString& language) {
    const std::optional<QString> english = sourceOf(id);
    if (!english) qFatal("no page of help %s", qPrintable(id));
    const QString source = sourceOf(language + QLatin1Char('/') + id).value_or(*english);
    const QString first = source.section(QLatin1Char('\n'), 0, 0);
    return {id, first.mid(first.indexOf(QLatin1Char(' ')) + 1).trimmed(), source,
            anchorsOf(*english)};
}

}  // namespace

int HelpPage::headingOf(const QString& anchor) const {
    return static_cast<int>(anchors.indexOf(anchor));
}

const std::vector<HelpPage>& helpPages() {
    static std::map<QString, std::vector<HelpPage>> byLanguage;
    std::vector<HelpPage>& pages = byLanguage[languageInUse()];
    if (pages.empty()) {
        for (const char* id : kPages)
            pages.push_back(readPage(QLatin1String(id), languageInUse()));
    }
    return pages;
}

const HelpPage* helpPage(const QString& id) {
    const auto& pages = helpPages();
    const auto found = std::find_if(pages.begin(), pages.end(),
                                    [&](const HelpPage& page) { return page.id == id; });
    return found == pages.end() ? nullptr : &*found;
}

QString shownText(const HelpPage& page, const CommandTable& commands) {
    QString text = replaced(page.source, keyPattern(), [&](const auto& match) {
        const Command* command = commands.find(match.captured(2));
        if (command == nullptr) return match.captured(1);
        if (command->keys.isEmpty()) return QStringLiteral("*%1*").arg(command->plainText());
        return '`' + command->keys.front().toString(QKeySequence::NativeText) + '`';
    });
    text = replaced(text, tablePattern(),
                    [&](const auto& match) { return tableOf(match.captured(1), commands); });
    const QString line = QStringLiteral("<!-- command line -->");
    if (text.contains(line)) text.replace(line, commandLine());
    return text;
}

std::vector<KeyMention> keyMentions(const HelpPage& page) {
    std::vector<KeyMention> mentions;
    for (auto each = keyPattern().globalMatch(page.source); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        mentions.push_back({match.captured(1), match.captured(2)});
    }
    return mentions;
}

QStringList commandTables(const HelpPage& page) {
    QStringList tables;
    for (auto each = tablePattern().globalMatch(page.source); each.hasNext();)
        tables.append(each.next().captured(1));
    return tables;
}

}  // namespace kumite::studio
