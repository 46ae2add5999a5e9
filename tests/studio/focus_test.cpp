// Keys wherever the focus is, and what the line at the bottom says.

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenuBar>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QTableView>
#include <QTest>

#include <cmath>

#include <fmt/format.h>

#include "core/project/report.h"
#include "studio/app/commands.h"
#include "studio/app/status_line.h"
#include "studio/app/workspaces.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/keyframe/key_strip.h"
#include "studio/workspaces/segment/segment_panel.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

/// ← and → lead through it: not through lists, nor tables of which rows are chosen.
bool isLedByArrows(const QWidget* widget) {
    const auto* table = qobject_cast<const QTableView*>(widget);
    if (widget->inherits("QListView") ||
        (table != nullptr && table->selectionBehavior() == QAbstractItemView::SelectRows))
        return false;
    for (const char* kind : {"QAbstractSlider", "QComboBox", "QAbstractItemView", "QTabBar"}) {
        if (widget->inherits(kind)) return true;
    }
    return false;
}

TEST_F(WindowTest, ArrowAndLetterKeysWorkWhereverTheFocusIs) {
    openBout();
    int tried = 0, led = 0;
    for (auto* widget : window_->findChildren<QWidget*>()) {
        const bool takesKeys = widget->isVisible() && widget->window() == window_.get() &&
                               widget->focusPolicy() != Qt::NoFocus;
        if (!takesKeys || widget->inherits("QAbstractSpinBox") || widget->inherits("QLineEdit"))
            continue;
        SCOPED_TRACE(std::string(widget->metaObject()->className()) + " " +
                     widget->accessibleName().toStdString());
        ++tried;
        session().transport().setPlayhead(0);
        session().select(std::nullopt);
        const auto steps = session().document().history().steps().size();
        widget->setFocus();
        if (isLedByArrows(widget)) {
            ++led;
        } else {
            QTest::keyClick(widget, Qt::Key_Right);
            EXPECT_EQ(session().shownFrame(0), 1);
            widget->setFocus();
            QTest::keyClick(widget, Qt::Key_Left);
            EXPECT_EQ(session().shownFrame(0), 0);
            EXPECT_EQ(session().document().history().steps().size(), steps) << "and nothing else";
            widget->setFocus();
        }
        QTest::keyClick(widget, Qt::Key_N);
        EXPECT_TRUE(session().selection());
    }
    EXPECT_GT(tried - led, 8);
}

TEST_F(WindowTest, ALetterInAFieldOfANumberIsACommandAndTheNumberIsKept) {
    openBout();
    int tried = 0;
    for (auto* field : window_->findChildren<QAbstractSpinBox*>()) {
        if (!field->isVisible() || field->window() != window_.get()) continue;
        SCOPED_TRACE(field->accessibleName().toStdString());
        ++tried;
        session().select(std::nullopt);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_N);
        ASSERT_TRUE(session().selection()) << "the next suspect";
        // The keys that follow belong to the command, too.
        EXPECT_TRUE(timeline().hasFocus());
        const auto position = session().document().history().position();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        EXPECT_EQ(session().document().history().position(), position + 1) << "kept";
        session().document().undo();
    }
    EXPECT_GE(tried, 2);
    QDoubleSpinBox* cutoff = nullptr;
    for (auto* field : window_->findChild<SegmentPanel*>()->findChildren<QDoubleSpinBox*>()) {
        if (field->accessibleName() == QStringLiteral("Cutoff of the low-pass in Hz"))
            cutoff = field;
    }
    ASSERT_NE(cutoff, nullptr);
    cutoff->setFocus();
    cutoff->selectAll();
    QTest::keyClicks(cutoff, "4");
    QTest::keyClick(cutoff, Qt::Key_N);
    settle();
    EXPECT_DOUBLE_EQ(session().document().project().segmentation.cutoff, 4.0);
    EXPECT_TRUE(session().selection());
}

TEST_F(WindowTest, ReturnIsTheJobsAgainAfterTheNextSuspectOrEscape) {
    openBout();
    const auto keysLine = [this] { return window_->findChild<StatusLine*>()->text(); };
    int tried = 0;
    for (auto* widget : window_->findChildren<QWidget*>()) {
        const bool isControl = widget->isVisible() && widget->window() == window_.get() &&
                               widget->focusPolicy() != Qt::NoFocus &&
                               widget != &window_->timeline() && widget != &window_->stage();
        if (!isControl) continue;
        SCOPED_TRACE(std::string(widget->metaObject()->className()) + " " +
                     widget->accessibleName().toStdString());
        ++tried;
        widget->setFocus();
        if (tried == 1) {
            EXPECT_TRUE(keysLine().contains("Esc ")) << keysLine().toStdString();
            EXPECT_FALSE(keysLine().contains("Return keep")) << keysLine().toStdString();
        }
        QTest::keyClick(widget, Qt::Key_Escape);
        EXPECT_EQ(QApplication::focusWidget(), &window_->timeline());
        if (widget->inherits("QLineEdit")) continue;
        widget->setFocus();
        QTest::keyClick(widget, Qt::Key_N);
        QTest::qWait(1);
        EXPECT_EQ(QApplication::focusWidget(), &window_->timeline());
        ASSERT_TRUE(session().selection());
        EXPECT_TRUE(tried > 1 || keysLine().contains("Return keep"));
        const BoundaryRef boundary = *session().selection();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backspace);
        EXPECT_FALSE(nearestMark(session().marks(boundary.player), boundary.frame, 0.5)->isLive());
        session().document().undo();
    }
    EXPECT_GT(tried, 10);
}

TEST_F(WindowTest, WhatIsDrawnAsAViewIsNoControl) {
    openBout();
    window_->workspaces().show("keyframe");
    settle();
    auto* strip = window_->findChild<KeyStrip*>();
    ASSERT_TRUE(strip->isVisible());
    strip->setFocus();
    EXPECT_FALSE(window_->findChild<StatusLine*>()->text().contains("Esc "));
    QTest::keyClick(strip, Qt::Key_Escape);
    EXPECT_EQ(QApplication::focusWidget(), strip);
}

TEST_F(WindowTest, AfterMenusByKeyboardTheNextSuspectCanBeDecided) {
    openBout();
    window_->timeline().setFocus();
    window_->menuBar()->setFocus();
    QTest::keyClick(window_->menuBar(), Qt::Key_N);
    QTest::qWait(1);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backspace);
    EXPECT_EQ(session().document().history().position(), 1U);
}

TEST_F(WindowTest, KeysThatWorkAControlAreNoCommands) {
    openBout();
    session().transport().setPlayhead(2);
    auto* panel = window_->findChild<SegmentPanel*>();
    ASSERT_NE(panel, nullptr);
    const auto shown = [](auto widgets) {
        widgets.removeIf([](const QWidget* widget) { return !widget->isVisible(); });
        return widgets;
    };
    std::vector<QWidget*> controls;
    for (QWidget* widget : shown(panel->findChildren<QSlider*>()))
        controls.push_back(widget);
    for (QWidget* widget : shown(panel->findChildren<QComboBox*>()))
        controls.push_back(widget);
    for (QWidget* widget : shown(panel->findChildren<QTableView*>()))
        controls.push_back(widget);
    ASSERT_GE(controls.size(), 4U);
    for (QWidget* control : controls) {
        SCOPED_TRACE(control->metaObject()->className());
        control->setFocus();
        QSignalSpy commands(&window_->commands(), &CommandTable::running);
        for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Left, Qt::Key_Up, Qt::Key_Down,
                                  Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown}) {
            // In the list of suspects ← and → stay steps of the playhead.
            const bool sideways = key == Qt::Key_Right || key == Qt::Key_Left;
            if (sideways && qobject_cast<QTableView*>(control) != nullptr) continue;
            QTest::keyClick(control, key);
            settle();
            EXPECT_EQ(commands.size(), 0) << "key " << key;
            control->setFocus();
        }
    }
    // They did work the controls.
    auto* slider = qobject_cast<QSlider*>(controls.front());
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Home);
    EXPECT_EQ(slider->value(), slider->minimum());
    QTest::keyClick(slider, Qt::Key_Right);
    EXPECT_GT(slider->value(), slider->minimum());
    settle();
    // Elsewhere, and with Ctrl, they are commands.
    session().select(std::nullopt);
    session().transport().setPlayhead(2);
    const double before = session().transport().playhead();
    QTest::keyClick(slider, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_GT(session().transport().playhead(), before);
    timeline().setFocus();
    press(Qt::Key_Home);
    EXPECT_EQ(session().transport().playhead(), 0);
}

TEST_F(WindowTest, TheLineOfKeysEndsInAllKeysHoweverNarrowTheWindow) {
    openBout();
    auto* line = window_->statusBar()->findChild<StatusLine*>();
    for (const int width : {900, 1280, 1900}) {
        window_->resize(width, 700);
        QTest::qWait(50);
        EXPECT_TRUE(line->text().endsWith("F1 help")) << width << line->text().toStdString();
    }
    const QString whole = line->text();
    const QFontMetrics metrics = line->fontMetrics();
    line->resize(metrics.horizontalAdvance(whole) / 2, line->height());
    EXPECT_TRUE(line->text().endsWith("F1 help")) << line->text().toStdString();
    EXPECT_LT(line->text().size(), whole.size());
    EXPECT_GT(line->text().size(), QString("F1 help").size());
    EXPECT_LE(metrics.horizontalAdvance(line->text()), line->width());
}

/// What the line at the bottom says.
QString statusOf(MainWindow& window) {
    return window.statusBar()->findChild<StatusLine*>()->text();
}

TEST_F(WindowTest, StatusLineSaysWhatHoldsNow) {
    EXPECT_TRUE(statusOf(*window_).isEmpty());
    openBout();
    EXPECT_TRUE(statusOf(*window_).contains("Space play"));
    EXPECT_FALSE(statusOf(*window_).contains("keep")) << "nothing is selected to be kept";
    session().transport().setPlaying(true);
    EXPECT_TRUE(statusOf(*window_).contains("Space pause"));
    session().transport().setPlaying(false);
    EXPECT_TRUE(statusOf(*window_).contains("Space play"));
    press(Qt::Key_N);
    EXPECT_TRUE(statusOf(*window_).contains("Backspace remove"));
    press(Qt::Key_Escape);
    EXPECT_FALSE(statusOf(*window_).contains("Backspace"));
    press(Qt::Key_M);
    EXPECT_TRUE(statusOf(*window_).contains("leave measuring"));
    press(Qt::Key_Escape);
    EXPECT_FALSE(statusOf(*window_).contains("measuring"));

    // What was said is over with the next act.
    press(Qt::Key_Return);
    EXPECT_TRUE(statusOf(*window_).startsWith("No boundary is selected"));
    session().transport().setPlaying(false);
    press(Qt::Key_Right);
    EXPECT_TRUE(statusOf(*window_).contains("Space play"));

    // A resting pointer: what is under it changes.
    const BoundaryRef boundary = someBoundary(0);
    session().setVisible({session().timeOf(boundary) - 1, session().timeOf(boundary) + 1});
    const QPoint pointer = timeline().pointOf(boundary).toPoint();
    hover(timeline(), pointer);
    EXPECT_FALSE(statusOf(*window_).contains("removed boundary"));
    session().toggleBoundary(boundary);
    EXPECT_TRUE(statusOf(*window_).contains("removed boundary"));
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(statusOf(*window_).contains("removed boundary"));
    session().setVisible({0, 1});
    const auto frame = std::lround(timeline().mapping().timeAt(pointer.x()) * 60);
    EXPECT_TRUE(statusOf(*window_).contains(QStringLiteral("frame %1").arg(frame)))
        << statusOf(*window_).toStdString();
}

TEST_F(WindowTest, AnActionHasOneNumberOnTheScreenAndInTheTable) {
    openBout();
    const auto& actions = session().fighter(1)->segmentation->actions;
    const std::size_t third = 3;
    const auto begin = actions[third].begin;
    session().setVisible({session().timeOf({1, begin}) - 0.2, session().timeOf({1, begin}) + 1.5});
    const QRectF block = timeline().blockOf({1, actions[third].peak});
    hover(timeline(), block.center().toPoint());
    EXPECT_TRUE(statusOf(*window_).contains("action 3")) << statusOf(*window_).toStdString();
    const std::string table =
        actionsCsv(session().document().project(), session().document().analysis(), 0);
    EXPECT_NE(table.find(fmt::format(",2,3,{},", begin)), std::string::npos) << table;
}

}  // namespace
}  // namespace kumite::studio
