#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace kumite::studio {

class CommandTable;

/// A page of the help: Markdown of resources/help (in other languages: resources/help/de), which
/// reads well in the repository, too. In it
///
///     [`N`](key:review.next)        stands for the key that a command has now,
///     <!-- commands: segment -->    for a table of a workspace's commands ("everywhere": of all),
///     <!-- command line -->         for what `kumite --help` says.
struct HelpPage {
    QString id;      ///< "segment": the file's name; of a workspace's page also the workspace
    QString title;   ///< its first heading
    QString source;  ///< as it stands in the file
    /// What its headings are linked to by, in their order: made of the English headings, so that a
    /// link ("method.md#expected-accuracy") is the same in every language.
    QStringList anchors;

    /// Which heading, counted from 0; -1 where there is none with that anchor.
    int headingOf(const QString& anchor) const;
};

/// All pages in the order of the contents, in the window's language; English where there is none in
/// it.
const std::vector<HelpPage>& helpPages();
/// Null where there is no such page.
const HelpPage* helpPage(const QString& id);
/// Markdown with the keys in force, the tables and the command line's help put in.
QString shownText(const HelpPage& page, const CommandTable& commands);

/// A key as a page names it.
struct KeyMention {
    QString key;      ///< as the file says it: the key that the studio brings
    QString command;  ///< whose it is
};
std::vector<KeyMention> keyMentions(const HelpPage& page);
/// Whose commands a page lists: ids of workspaces, "everywhere".
QStringList commandTables(const HelpPage& page);

}  // namespace kumite::studio
