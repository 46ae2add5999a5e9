// For every eye and every hand: contrast, colours, size of text, motion.

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QSettings>
#include <QTest>

#include "core/labelling/vocabulary.h"
#include "studio/app/colour_vision.h"
#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/theme.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/lane_painter.h"
#include "studio/workspaces/label/label_review.h"
#include "studio/workspaces/label/label_session.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

TEST(Comfort, TextHasContrastInBothThemes) {
    constexpr double kReadable = 4.5;  // WCAG 2, level AA
    for (const bool dark : {true, false}) {
        SCOPED_TRACE(dark ? "dark" : "light");
        const Colours& c = colours(dark);
        for (const QColor& behind : {c.ground, c.panel}) {
            for (const QColor& text : {c.text, c.secondText, c.fighterText[0], c.fighterText[1]}) {
                EXPECT_GE(contrastOf(text, behind), kReadable)
                    << text.name().toStdString() << " on " << behind.name().toStdString();
            }
        }
        // What is chosen, hovered or being marked in the help.
        for (const QColor& behind :
             {mixed(c.panel, c.line, 0.9), mixed(c.panel, c.accent, dark ? 0.28 : 0.32)})
            EXPECT_GE(contrastOf(c.text, behind), kReadable) << behind.name().toStdString();
    }
}

TEST(Comfort, TheFightersAreToldApartByEveryEye) {
    for (const bool dark : {true, false}) {
        const Colours& c = colours(dark);
        EXPECT_GT(leastDifference(c.fighters[0], c.fighters[1]), 40);
        EXPECT_GT(leastDifference(c.fighterText[0], c.fighterText[1]), 40);
    }
}

TEST(Comfort, ClassesAreToldApartByColourOrPattern) {
    int patterned = 0, all = 0;
    for (const bool dark : {true, false}) {
        for (const Aspect& aspect : kickboxing().aspects) {
            SCOPED_TRACE(aspect.id + (dark ? " dark" : " light"));
            std::vector<QColor> shown;
            for (const Qualifier& qualifier : aspect.qualifiers) {
                shown.push_back(
                    classColour(QColor(QString::fromStdString(qualifier.colour)), colours(dark)));
            }
            const auto patterns = classPatterns(shown);
            for (std::size_t i = 0; i < shown.size(); ++i) {
                ++all;
                patterned += patterns[i] != Qt::NoBrush;
                for (std::size_t j = 0; j < i; ++j) {
                    EXPECT_TRUE(patterns[i] != patterns[j] ||
                                leastDifference(shown[i], shown[j]) >= kToldApart)
                        << i << " and " << j;
                }
            }
        }
    }
    EXPECT_LT(patterned, all / 2) << "colour is the first sign, patterns help out";
}

TEST(Comfort, SimulatedEyesConfuseWhatRealOnesDo) {
    // Known answers: red and green for protan and deutan eyes, grey for nobody.
    EXPECT_EQ(seenBy(Qt::white, Vision::Protan).name(), "#ffffff");
    const QColor red("#c04000"), green("#607000");
    EXPECT_GT(colourDifference(red, green), 60);
    EXPECT_LT(colourDifference(seenBy(red, Vision::Deutan), seenBy(green, Vision::Deutan)), 30);
    EXPECT_NEAR(colourDifference(Qt::white, Qt::black), 100, 0.1);
}

class ComfortTest : public WindowTest {
protected:
    void TearDown() override {
        WindowTest::TearDown();
        setTextSize(100);
        setMotionReduced(false);
        applyTheme(ThemeChoice::Dark);
    }
    void setSize(int percent) {
        PreferenceValues values = window_->preferences().values();
        values.textSize = percent;
        window_->preferences().set(values);
        settle();
    }
    /// Buttons and labels that are lower than their letters.
    QStringList clipped() {
        QStringList all;
        for (auto* widget : window_->findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->window() != window_.get()) continue;
            const auto* button = qobject_cast<QAbstractButton*>(widget);
            const auto* label = qobject_cast<QLabel*>(widget);
            const QString text = button ? button->text() : label ? label->text() : QString();
            if (!text.isEmpty() && widget->height() + 2 < widget->fontMetrics().height())
                all.append(widget->parentWidget()->metaObject()->className() + (": " + text));
        }
        return all;
    }
};

TEST_F(ComfortTest, TextGrowsAndEveryWorkspaceHasRoomForIt) {
    openBout();
    const double before = QApplication::font().pointSizeF();
    for (const int percent : {150, 200}) {
        SCOPED_TRACE(percent);
        setSize(percent);
        EXPECT_DOUBLE_EQ(QApplication::font().pointSizeF(), before * percent / 100);
        for (const Workspace& workspace : window_->workspaces().all()) {
            SCOPED_TRACE(workspace.id.toStdString());
            window_->workspaces().show(workspace.id);
            settle();
            EXPECT_LE(window_->width(), 1280);
            EXPECT_LE(window_->height(), 800) << "panels scroll instead";
            EXPECT_TRUE(clipped().isEmpty()) << clipped().join(" | ").toStdString();
        }
    }
    setSize(100);
    EXPECT_DOUBLE_EQ(QApplication::font().pointSizeF(), before);
}

TEST_F(ComfortTest, KeysMakeTextLargerAndItStaysSo) {
    openBout();
    press(Qt::Key_Plus, Qt::ControlModifier | Qt::AltModifier);
    settle();
    EXPECT_EQ(window_->preferences().values().textSize, 125);
    EXPECT_EQ(QSettings().value("textSize").toInt(), 125);
    press(Qt::Key_Minus, Qt::ControlModifier | Qt::AltModifier);
    press(Qt::Key_Minus, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(window_->preferences().values().textSize, 100);
    // A new window begins with the size that was chosen.
    setSize(200);
    const double large = QApplication::font().pointSizeF();
    window_.reset();
    window_ = std::make_unique<MainWindow>();
    EXPECT_DOUBLE_EQ(QApplication::font().pointSizeF(), large);
}

TEST_F(ComfortTest, WithLessMotionQuestionsStandStill) {
    openBout();
    window_->workspaces().show("label");
    settle();
    press(Qt::Key_N);
    settle();
    EXPECT_TRUE(session().transport().isPlaying());
    session().transport().setPlaying(false);
    PreferenceValues values = window_->preferences().values();
    values.reduceMotion = true;
    window_->preferences().set(values);
    press(Qt::Key_N);
    settle();
    EXPECT_TRUE(session().selectedAction());
    EXPECT_FALSE(session().transport().isPlaying());
}

}  // namespace
}  // namespace kumite::studio
