// The help: its pages name what is there, the window shows and searches them, and everything in the
// studio says what it is.

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTest>
#include <QTextBlock>
#include <QUrl>
#include <QWhatsThis>

#include <sstream>

#include "core/cli/run.h"
#include "studio/app/commands.h"
#include "studio/app/language.h"
#include "studio/app/workspaces.h"
#include "studio/help/help.h"
#include "studio/help/help_pages.h"
#include "studio/help/help_view.h"
#include "studio/help/help_window.h"
#include "studio/help/topics.h"
#include "studio/help/whats_this.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class HelpTest : public WindowTest {
protected:
    HelpWindow* page() {
        QTest::qWait(20);
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* shown = qobject_cast<HelpWindow*>(widget);
            if (shown != nullptr && shown->isVisible()) return shown;
        }
        return nullptr;
    }
    HelpView& view() { return *page()->findChild<HelpView*>(); }
    QListWidget& contents() { return *page()->findChild<QListWidget*>(); }
    QLineEdit& searchField() { return *page()->findChild<QLineEdit*>(); }
    QString shown() { return view().toPlainText(); }
    CommandTable& commands() { return window_->commands(); }
};

TEST_F(HelpTest, KeysNamedInThePagesAreThoseOfTheCommands) {
    int mentions = 0;
    for (const HelpPage& page : helpPages()) {
        for (const KeyMention& mention : keyMentions(page)) {
            SCOPED_TRACE((page.id + ": " + mention.command).toStdString());
            ++mentions;
            ASSERT_NE(commands().find(mention.command), nullptr);
            const auto& keys = commands().defaultKeys(mention.command);
            ASSERT_FALSE(keys.isEmpty());
            EXPECT_EQ(keys.front().toString(QKeySequence::PortableText), mention.key);
        }
        EXPECT_FALSE(shownText(page, commands()).contains("](key:")) << page.id.toStdString();
    }
    EXPECT_GT(mentions, 100);
}

/// Headings by level, targets of links with keys as they are named, comments, columns of tables.
QStringList skeletonOf(const QString& source) {
    QStringList links, rest;
    static const QRegularExpression heading(QStringLiteral("^#+ "));
    static const QRegularExpression target(
        QStringLiteral("(?:\\[(`[^`]+`)\\])?\\((key:[^)]+)\\)|\\]\\(([^)]+)\\)"));
    static const QRegularExpression comment(QStringLiteral("<!--.*-->"));
    for (const QString& line : source.split('\n')) {
        if (const auto found = heading.match(line); found.hasMatch()) rest.append(found.captured());
        if (const auto found = comment.match(line); found.hasMatch()) rest.append(found.captured());
        if (line.startsWith('|')) rest.append(QString(line.count('|'), '|'));
        for (auto each = target.globalMatch(line); each.hasNext();)
            links.append(each.next().captured());
    }
    links.sort();
    return rest + links;
}

TEST_F(HelpTest, EveryPageStandsInEveryLanguageAndSaysTheSame) {
    const std::vector<HelpPage> english = helpPages();
    for (const Language& language : languages()) {
        useLanguage(language.code);
        ASSERT_EQ(helpPages().size(), english.size());
        for (std::size_t i = 0; i < english.size(); ++i) {
            SCOPED_TRACE((language.code + ": " + english[i].id).toStdString());
            const HelpPage& page = helpPages()[i];
            EXPECT_EQ(skeletonOf(page.source), skeletonOf(english[i].source));
            EXPECT_EQ(page.anchors, english[i].anchors);
            if (language.code != "en") {
                EXPECT_NE(page.source, english[i].source);
                EXPECT_FALSE(page.title.isEmpty());
            }
        }
        for (const QString& place : allTopics())
            EXPECT_FALSE(topicSummary(place).isEmpty()) << place.toStdString();
    }
    useLanguage("en");
}

TEST_F(HelpTest, EveryCommandStandsOnThePageOfItsWorkspace) {
    for (const Workspace& workspace : window_->workspaces().all()) {
        ASSERT_NE(helpPage(workspace.id), nullptr) << workspace.id.toStdString();
    }
    for (const Command& command : commands().commands()) {
        const QStringList places = command.workspace.isEmpty()
                                       ? QStringList{"keys"}
                                       : command.workspace.split(QLatin1Char(' '));
        for (const QString& place : places) {
            const HelpPage* page = helpPage(place);
            ASSERT_NE(page, nullptr);
            EXPECT_TRUE(shownText(*page, commands()).contains("| " + command.plainText()))
                << command.id.toStdString() << " is not on " << place.toStdString();
        }
    }
}

TEST_F(HelpTest, EveryLinkLeadsSomewhere) {
    const QRegularExpression link("\\]\\(([^)]+)\\)");
    const auto check = [&](const QString& target, const QString& own) {
        const QUrl url(target);
        if (url.scheme() == "key") return;
        if (url.scheme() == "command") {
            EXPECT_NE(commands().find(url.path()), nullptr) << target.toStdString();
            return;
        }
        if (!url.scheme().isEmpty()) return;
        const HelpPage* page = helpPage(url.path().isEmpty() ? own : url.path().section('.', 0, 0));
        ASSERT_NE(page, nullptr) << target.toStdString();
        EXPECT_TRUE(url.fragment().isEmpty() || page->anchors.contains(url.fragment()))
            << target.toStdString();
    };
    for (const HelpPage& page : helpPages()) {
        SCOPED_TRACE(page.id.toStdString());
        for (auto each = link.globalMatch(page.source); each.hasNext();)
            check(each.next().captured(1), page.id);
    }
    for (const QString& place : allTopics()) {
        EXPECT_TRUE(helpPage("method")->anchors.contains(place.section('#', 1)))
            << place.toStdString();
        EXPECT_GT(topicSummary(place).size(), 40) << place.toStdString();
    }
}

TEST_F(HelpTest, TheCommandLinesPageIsWhatTheCommandSays) {
    const QString text = shownText(*helpPage("command_line"), commands());
    for (const char* command : {"demo", "segment", "labels", "bout", "keyframes"}) {
        std::ostringstream out;
        ASSERT_EQ(cli::run({command, "--help"}, out, out), 0);
        for (const QString& line : QString::fromStdString(out.str()).split('\n')) {
            EXPECT_TRUE(text.contains(line.trimmed())) << command << ": " << line.toStdString();
        }
    }
}

TEST_F(HelpTest, OpensThePageOfTheWorkspace) {
    QTest::keyClick(window_.get(), Qt::Key_F1);
    ASSERT_NE(page(), nullptr);
    EXPECT_EQ(page()->page(), "first_steps");
    openBout();
    press(Qt::Key_F1);
    EXPECT_EQ(page()->page(), "segment");
    for (const Workspace& workspace : window_->workspaces().all()) {
        window_->workspaces().show(workspace.id);
        settle();
        commands().run("help.open");
        EXPECT_EQ(page()->page(), workspace.id);
        EXPECT_TRUE(shown().startsWith(helpPage(workspace.id)->title));
    }
}

TEST_F(HelpTest, NamesTheKeysInForce) {
    window_->help().open("segment");
    EXPECT_TRUE(shown().contains("Backspace removes it")) << shown().left(400).toStdString();
    commands().setKeys("review.reject", {QKeySequence("Ctrl+Alt+X")});
    EXPECT_TRUE(shown().contains("Ctrl+Alt+X removes it"));
    commands().setKeys("review.reject", {});
    EXPECT_TRUE(shown().contains("Remove: it is spurious removes it"));
}

TEST_F(HelpTest, FindsWordsOnAllPagesAndLeadsFromPlaceToPlace) {
    window_->help().open("first_steps");
    const int all = contents().count();
    QTest::keyClicks(&searchField(), "prominence");
    EXPECT_LT(contents().count(), all);
    EXPECT_GE(contents().count(), 2) << "Segment and the method page at least";
    EXPECT_TRUE(view().toPlainText().contains("prominence", Qt::CaseInsensitive));
    ASSERT_GT(view().markCount(), 0);
    EXPECT_EQ(view().extraSelections().size(), view().markCount());
    EXPECT_EQ(view().currentMark(), 0);
    const QString first = page()->page();
    // From place to place, then on to the next page.
    for (int i = view().markCount(); i > 0; --i)
        QTest::keyClick(&searchField(), Qt::Key_Return);
    EXPECT_NE(page()->page(), first);
    EXPECT_EQ(view().currentMark(), 0);
    QTest::keyClick(&searchField(), Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_EQ(page()->page(), first);
    EXPECT_EQ(view().currentMark(), view().markCount() - 1);
    // All words must be there.
    searchField().clear();
    QTest::keyClicks(&searchField(), "prominence nosuchword");
    EXPECT_EQ(contents().count(), 0);
    searchField().clear();
    EXPECT_EQ(contents().count(), all);
    EXPECT_EQ(view().markCount(), 0);
}

TEST_F(HelpTest, LinksLeadToPagesPlacesAndBack) {
    window_->help().open("graph");
    Q_EMIT view().anchorClicked(QUrl("method.md#surprise"));
    EXPECT_EQ(page()->page(), "method");
    QTest::qWait(20);
    EXPECT_EQ(view().textCursor().block().text(), "Surprise");
    QApplication::setActiveWindow(page());
    QTest::keyClick(&searchField(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(page()->page(), "graph");
    QTest::keyClick(&searchField(), Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(page()->page(), "method");
    Q_EMIT view().anchorClicked(QUrl("command:help.keys"));
    QTest::qWait(20);
    bool keys = false;
    for (QWidget* widget : QApplication::topLevelWidgets())
        keys = keys || (widget->isVisible() && widget->inherits("kumite::studio::KeysPage"));
    EXPECT_TRUE(keys);
}

TEST_F(HelpTest, ThePagesBesideTheWindowHaveTheirPage) {
    openBout();
    commands().run("fighter.properties");
    QTest::qWait(20);
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (widget->isVisible() && widget->inherits("kumite::studio::FighterProperties"))
            QTest::keyClick(widget, Qt::Key_F1);
    }
    ASSERT_NE(page(), nullptr);
    EXPECT_EQ(page()->page(), "importing");
}

TEST_F(HelpTest, WhatsThisNamesKeyAndFormula) {
    openBout();
    QWidget* cutoff = nullptr;
    for (auto* label : window_->findChildren<QWidget*>()) {
        if (label->isVisible() && label->accessibleName().startsWith("Cutoff")) cutoff = label;
    }
    ASSERT_NE(cutoff, nullptr);
    EXPECT_TRUE(whatsThisOf(*cutoff, commands()).contains("help:method#cutoff"));
    // By keyboard: of what has the focus.
    cutoff->setFocus();
    QTest::keyClick(cutoff, Qt::Key_F1, Qt::AltModifier);
    QTest::qWait(20);
    QWidget* balloon = nullptr;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (widget->isVisible() && widget->inherits("QWhatsThat")) balloon = widget;
    }
    ASSERT_NE(balloon, nullptr);
    QWhatsThis::hideText();
    QWhatsThisClickedEvent click("help:method#cutoff");
    QApplication::sendEvent(cutoff, &click);
    ASSERT_NE(page(), nullptr);
    EXPECT_EQ(page()->page(), "method");
    // A button that runs a command.
    for (auto* button : window_->findChildren<QAbstractButton*>()) {
        if (button->property("command") != "review.reject") continue;
        EXPECT_TRUE(whatsThisOf(*button, commands()).contains("Backspace"));
        commands().setKeys("review.reject", {QKeySequence("Ctrl+Alt+X")});
        EXPECT_TRUE(whatsThisOf(*button, commands()).contains("Ctrl+Alt+X"));
    }
}

}  // namespace
}  // namespace kumite::studio
