// The window's languages: their files are whole, and every workspace stands in each of them.

#include "studio/app/language.h"

#include <QAbstractButton>
#include <QAction>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <map>
#include <set>

#include "studio/app/commands.h"
#include "studio/app/core_texts.h"
#include "studio/app/core_words.h"
#include "studio/app/file_actions.h"
#include "studio/app/message_strip.h"
#include "studio/app/opening.h"
#include "studio/app/recovery.h"
#include "studio/app/window_keeper.h"
#include "studio/app/words.h"
#include "studio/app/workspaces.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

struct Entry {
    QString context, source;
    QStringList forms;
    bool finished = true;
    bool plural = false;
};

std::vector<Entry> entriesOf(const QString& code) {
    QFile file(QStringLiteral(KUMITE_SOURCE_DIR "/translations/kumite_%1.ts").arg(code));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
    QXmlStreamReader xml(&file);
    std::vector<Entry> entries;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const auto name = xml.name();
        if (name == u"name") context = xml.readElementText();
        if (name == u"message") {
            Entry entry;
            entry.context = context;
            entry.plural = xml.attributes().value("numerus") == u"yes";
            entries.push_back(entry);
        }
        if (name == u"source") entries.back().source = xml.readElementText();
        if (name == u"translation") {
            entries.back().finished = !xml.attributes().hasAttribute("type");
            if (!entries.back().plural) entries.back().forms.append(xml.readElementText());
        }
        if (name == u"numerusform") entries.back().forms.append(xml.readElementText());
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return entries;
}

/// %1, %2, %n as often as they stand there.
QStringList places(const QString& text) {
    static const QRegularExpression place(QStringLiteral("%(?:L?\\d|n)"));
    QStringList found;
    for (auto all = place.globalMatch(text); all.hasNext();)
        found.append(all.next().captured());
    found.sort();
    return found;
}

/// Texts that are the same in some languages: names, symbols, and words that were borrowed.
bool maySame(const QString& language, const QString& source) {
    static const QRegularExpression noWord(QStringLiteral("^[^a-zA-Z]*$"));
    QString letters = source;
    static const QRegularExpression kept(QStringLiteral("%(?:L?\\d|n)|&"));
    letters.remove(kept);
    if (noWord.match(letters).hasMatch() || letters.trimmed().size() <= 3) return true;
    QFile list(QStringLiteral(KUMITE_SOURCE_DIR "/translations/same.txt"));
    EXPECT_TRUE(list.open(QIODevice::ReadOnly));
    static const QStringList all = QString::fromUtf8(list.readAll()).split('\n');
    return all.contains(language + '\t' + source);
}

class EveryLanguage : public testing::TestWithParam<QString> {};

TEST_P(EveryLanguage, HasEveryTextOnceAndWhole) {
    const std::vector<Entry> entries = entriesOf(GetParam());
    EXPECT_GT(entries.size(), 1000U);
    const bool oneForm = GetParam() != "de" && GetParam() != "fr";
    for (const Entry& entry : entries) {
        SCOPED_TRACE(entry.context.toStdString() + ": " + entry.source.toStdString());
        EXPECT_TRUE(entry.finished);
        EXPECT_EQ(entry.forms.size(), entry.plural && !oneForm ? 2 : 1);
        for (const QString& form : entry.forms) {
            EXPECT_FALSE(form.isEmpty());
            // A singular may say "one" in words.
            const bool singular = entry.plural && form == entry.forms.front() && !oneForm;
            if (!singular) {
                EXPECT_EQ(places(form), places(entry.source)) << form.toStdString();
            }
            EXPECT_EQ(form.contains(QRegularExpression("&\\w")),
                      entry.source.contains(QRegularExpression("&\\w")))
                << form.toStdString();
            if (!maySame(GetParam(), entry.source)) {
                EXPECT_NE(form, entry.source);
            }
        }
    }
}

TEST_P(EveryLanguage, HasTheTextsOfAllOthers) {
    std::set<std::pair<QString, QString>> here, there;
    for (const Entry& entry : entriesOf(GetParam()))
        here.insert({entry.context, entry.source});
    for (const Entry& entry : entriesOf("de"))
        there.insert({entry.context, entry.source});
    EXPECT_EQ(here, there);
}

INSTANTIATE_TEST_SUITE_P(, EveryLanguage, testing::Values("de", "fr", "ja", "ko", "zh_TW"),
                         [](const auto& info) { return info.param.toStdString(); });

/// A window in a language; English again afterwards.
class LanguageTest : public WindowTest, public testing::WithParamInterface<QString> {
protected:
    void SetUp() override {
        useLanguage(GetParam());
        WindowTest::SetUp();
    }
    void TearDown() override {
        WindowTest::TearDown();
        useLanguage("en");
    }
};

TEST_P(LanguageTest, MenusHaveAKeyForEachOfTheirEntries) {
    openBout();
    for (const char* workspace : {"segment", "label", "graph", "bout", "sequence", "keyframe"}) {
        window_->workspaces().show(workspace);
        window_->commands().refresh();
        std::map<QChar, QString> titles;
        static const QRegularExpression mark(QStringLiteral("&(\\w)"));
        for (const QAction* menu : window_->menuBar()->actions()) {
            if (!menu->isVisible()) continue;
            const QString letter = mark.match(menu->text()).captured(1).toLower();
            ASSERT_FALSE(letter.isEmpty()) << menu->text().toStdString();
            EXPECT_TRUE(titles.emplace(letter[0], menu->text()).second)
                << workspace << ": " << menu->text().toStdString() << " and "
                << titles[letter[0]].toStdString();
            std::map<QChar, QStringList> entries;
            int lettered = 0;
            for (const QAction* entry : menu->menu()->actions()) {
                const QString key = mark.match(entry->text()).captured(1).toLower();
                if (key.isEmpty() || !entry->isVisible()) continue;
                entries[key[0]].append(entry->text());
                ++lettered;
            }
            // A long menu has more entries than there are letters that suit them.
            if (lettered > 18) continue;
            for (const auto& [letter, texts] : entries) {
                EXPECT_EQ(texts.size(), 1) << workspace << ", " << menu->text().toStdString()
                                           << ": " << texts.join(" and ").toStdString();
            }
        }
    }
}

TEST_P(LanguageTest, EveryWorkspaceStandsInIt) {
    openBout();
    for (const char* workspace : {"segment", "label", "graph", "bout", "sequence", "keyframe"}) {
        SCOPED_TRACE(workspace);
        window_->workspaces().show(workspace);
        settle();
        EXPECT_FALSE(window_->grab().isNull());
    }
}

INSTANTIATE_TEST_SUITE_P(, LanguageTest, testing::Values("de", "fr", "ja", "ko", "zh_TW", "pseudo"),
                         [](const auto& info) { return info.param.toStdString(); });

class PseudoTest : public WindowTest {
protected:
    void SetUp() override {
        useLanguage("pseudo");
        WindowTest::SetUp();
    }
    void TearDown() override {
        WindowTest::TearDown();
        useLanguage("en");
    }
};

TEST_F(PseudoTest, NoTextOfTheWindowEscapesTranslation) {
    openBout();
    // What is no text of ours: names of files and takes, numbers, keys, names of languages.
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{4,}"));
    const auto isOurs = [&](QString text) {
        if (text.contains('~')) return false;
        text.remove(QStringLiteral("left")).remove(QStringLiteral("right.bvh"));
        text.remove(QRegularExpression("\\b(Ctrl|Shift|Backspace|Return|PgUp|PgDown|Home|End)\\b"));
        if (text == QStringLiteral("Kumite") || text.startsWith(QLatin1Char('/'))) return false;
        return text.contains(word) && !text.contains(".bvh") && !text.contains("Ctrl");
    };
    int seen = 0;
    for (const char* workspace : {"segment", "label", "graph", "bout", "sequence", "keyframe"}) {
        window_->workspaces().show(workspace);
        settle();
        const auto check = [&](const QString& text, const QWidget* widget) {
            if (text.contains('~')) ++seen;
            EXPECT_FALSE(isOurs(text))
                << workspace << ": " << text.toStdString() << " of "
                << widget->metaObject()->className() << ' ' << widget->objectName().toStdString();
        };
        for (auto* button : window_->findChildren<QAbstractButton*>())
            check(button->text(), button);
        for (auto* label : window_->findChildren<QLabel*>())
            check(label->text(), label);
        for (auto* widget : window_->findChildren<QWidget*>()) {
            check(widget->toolTip(), widget);
            check(widget->accessibleName(), widget);
        }
    }
    for (const Command& command : window_->commands().commands())
        EXPECT_FALSE(isOurs(command.plainText())) << command.id.toStdString();
    EXPECT_GT(seen, 300);
}

/// What stands between the quotes of a call such as `throw Error(…)`, piece by piece.
QStringList literalsOf(const QString& source, qsizetype begin) {
    QStringList literals;
    int depth = 0;
    qsizetype lastEnd = -2;
    for (qsizetype i = begin; i < source.size(); ++i) {
        const QChar c = source[i];
        if (c == '\'') {
            i += source[i + 1] == '\\' ? 3 : 2;
        } else if (c == '"') {
            QString text;
            for (++i; source[i] != '"'; ++i) {
                if (source[i] == '\\') ++i;
                text += source[i];
            }
            // Strings that follow each other are one.
            const bool goesOn =
                lastEnd >= 0 &&
                source.mid(lastEnd + 1, i - lastEnd - text.size()).trimmed()[0] == '"';
            if (goesOn) {
                literals.back() += text;
            } else {
                literals.append(text);
            }
            lastEnd = i;
        } else if (c == '(') {
            ++depth;
        } else if (c == ')' && --depth == 0) {
            break;
        } else if (!c.isSpace()) {
            lastEnd = -2;
        }
    }
    return literals;
}

TEST(Languages, EverySentenceOfTheCoreIsKnownToTheTranslators) {
    static const QRegularExpression place(QStringLiteral("%\\d|\\{[^{}]*\\}"));
    const auto plain = [](QString text) {
        return text.replace("{{", "(").replace("}}", ")").replace(place, "#").replace('}', ')');
    };
    QString known;
    for (const CoreText& text : sentenceTexts())
        known += plain(QString::fromUtf8(text.source)) + '\n';
    static const QRegularExpression call(
        QStringLiteral("\\b(?:throw (?:Error|InputError)|warning|note|fail\\w*|refuse)\\s*\\("));
    int seen = 0;
    QDirIterator files(KUMITE_SOURCE_DIR "/core", {"*.cpp", "*.h"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString path = files.next();
        // The command line speaks English.
        if (path.contains("/core/cli/")) continue;
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QString source = QString::fromUtf8(file.readAll());
        for (auto each = call.globalMatch(source); each.hasNext();) {
            for (const QString& literal : literalsOf(source, each.next().capturedEnd() - 1)) {
                QString text = plain(literal).trimmed();
                // Of a sentence that is made of pieces the long ones tell.
                if (text.count(' ') < 2) continue;
                ++seen;
                // What precedes the colon of a path is no part of the sentence.
                static const QRegularExpression before(QStringLiteral("^(#?:)+ "));
                QString pattern = QRegularExpression::escape(text.remove(before));
                pattern.replace(QStringLiteral("\\#"), QStringLiteral("[^\n]*?"));
                EXPECT_TRUE(known.contains(QRegularExpression(pattern)))
                    << file.fileName().toStdString() << ": " << text.toStdString();
            }
        }
    }
    EXPECT_GT(seen, 200);
}

TEST(Languages, ErrorsAreSaidWithTheirPlace) {
    useLanguage("de");
    const QString error = coreWords(
        "/takes/a: b/bout.bvh:12:4: found 'X', expected the number of "
        "channels, 0 to 6");
    EXPECT_TRUE(error.startsWith("/takes/a: b/bout.bvh:12:4: ")) << error.toStdString();
    EXPECT_TRUE(error.contains("'X'"));
    EXPECT_FALSE(error.contains("found") || error.contains("channels")) << error.toStdString();
    const QString left = coreWords(
        "bout.bvh: there is no such file. The recording is left out; its "
        "corrections are kept.");
    EXPECT_FALSE(left.contains("there is") || left.contains("recording")) << left.toStdString();
    EXPECT_FALSE(coreWords("opponent's right kick up, closing 4.1 m/s").contains("kick"));
    EXPECT_TRUE(coreWords("opponent's right kick up, closing 4.1 m/s").contains("4.1"));
    // A user's names stay, whatever they read like; nor are they taken for places.
    EXPECT_TRUE(coreWords("There is a take named \"no action there.\" already.")
                    .contains("no action there."));
    const QString odd = coreWords("The block \"%2 %1\" has no motion.");
    EXPECT_TRUE(odd.contains("%2 %1")) << odd.toStdString();
    const QString frames = coreWords("Frames 1:2 cannot be taken from \"%1\", which has 9.");
    EXPECT_TRUE(frames.contains("%1") && frames.contains('9')) << frames.toStdString();
    EXPECT_NE(roleWords(Role::LeftWrist), "left wrist");
    useLanguage("en");
    EXPECT_EQ(roleWords(Role::LeftWrist), "left wrist");
}

TEST(Languages, WhatTheCoreSaysIsTranslatedPieceByPiece) {
    useLanguage("de");
    EXPECT_FALSE(coreWords("Remove boundary at 0:12.30, fighter 1").contains("boundary"));
    EXPECT_TRUE(coreWords("Remove boundary at 0:12.30, fighter 1").contains("0:12.30"));
    EXPECT_TRUE(coreWords("Rename take to boundary").contains("boundary")) << "a name stays";
    EXPECT_FALSE(coreWords("Label action 12, fighter 1: left punch forward, right kick up")
                     .contains("kick"));
    EXPECT_EQ(coreWords("Something that nobody knows"), "Something that nobody knows");
    useLanguage("en");
    EXPECT_EQ(coreWords("Remove boundary at 0:12.30, fighter 1"),
              "Remove boundary at 0:12.30, fighter 1");
    EXPECT_EQ(editsText(1), "1 edit");
    EXPECT_EQ(editsText(2), "2 edits");
    EXPECT_EQ(withoutMnemonic("&Open…"), "Open…");
    EXPECT_EQ(withoutMnemonic("開く(&O)…"), "開く…");
}

class KeeperTest : public WindowTest {
protected:
    void TearDown() override {
        PreferenceValues values = window_->preferences().values();
        values.language.clear();
        window_->preferences().set(values);
        useLanguage("en");
        WindowTest::TearDown();
    }
};

TEST_F(KeeperTest, AnotherLanguageComesWithoutALossAndWithoutARestart) {
    QDir(Recovery::folder()).removeRecursively();
    WindowKeeper keeper;
    keeper.keepCopies();
    keeper.window().show();
    keeper.window().files().openBout(requestFor(recordings()), false);
    const auto idle = [&] { return !keeper.window().isBusy(); };
    ASSERT_TRUE(QTest::qWaitFor(idle, 20000));
    ASSERT_TRUE(keeper.window().files().saveTo(file("bout.kumite")));
    Session& before = keeper.window().session();
    before.toggleBoundary({0, before.marks(0)[3].frame});
    before.toggleBoundary({1, before.marks(1)[3].frame});
    ASSERT_TRUE(QTest::qWaitFor(idle, 20000));
    keeper.window().messages().showFindings("Found while reading", {note("No neck.")});
    before.document().undo();
    before.transport().setPlayhead(1.25);
    keeper.window().workspaces().show("label");
    const Project project = before.document().project();
    const auto steps = before.document().history().steps().size();

    QSignalSpy replaced(&keeper, &WindowKeeper::replaced);
    PreferenceValues values = keeper.window().preferences().values();
    values.language = "de";
    keeper.window().preferences().set(values);
    ASSERT_TRUE(QTest::qWaitFor([&] { return replaced.count() == 1; }, 20000));
    MainWindow& now = keeper.window();
    EXPECT_TRUE(now.isVisible());
    EXPECT_EQ(languageInUse(), "de");
    EXPECT_NE(now.commands().find("file.save")->plainText(), "Save");
    const Document& document = now.session().document();
    EXPECT_EQ(document.project(), project);
    EXPECT_EQ(document.history().steps().size(), steps) << "what was undone can be redone";
    EXPECT_TRUE(document.canRedo());
    EXPECT_TRUE(document.isModified());
    EXPECT_EQ(document.path(), file("bout.kumite"));
    EXPECT_DOUBLE_EQ(now.session().transport().playhead(), 1.25);
    EXPECT_EQ(now.workspaces().current(), "label");
    bool counted = false;
    for (auto* button : now.findChildren<QAbstractButton*>())
        counted = counted || (button->isVisible() && button->text().startsWith("1 "));
    EXPECT_TRUE(counted) << "what was found in the recordings";
    EXPECT_EQ(QDir(Recovery::folder()).entryList({"*.edit"}, QDir::Files).size(), 1)
        << "the unsaved edit is kept for a crash";
    ASSERT_TRUE(QTest::qWaitFor(idle, 20000));
    EXPECT_TRUE(now.files().saveTo(file("bout.kumite"))) << "nobody is asked whose file it is";
    EXPECT_FALSE(document.isModified());
}

}  // namespace
}  // namespace kumite::studio
