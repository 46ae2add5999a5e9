#include "studio/app/loop_watch.h"

#include <gtest/gtest.h>

#include <QTest>
#include <QWidget>

#include <thread>

namespace kumite::studio {
namespace {

using namespace std::chrono_literals;

/// Takes its time over an event.
class Sluggish : public QWidget {
    Q_OBJECT

public:
    std::chrono::milliseconds takes = 0ms;

protected:
    bool event(QEvent* event) override {
        if (event->type() == QEvent::User) std::this_thread::sleep_for(takes);
        return QWidget::event(event);
    }
};

TEST(LoopWatch, TellsWhatKeptTheLoopFromComingRound) {
    Sluggish widget;
    LoopWatch watch;
    QTest::qWait(20);
    watch.reset();
    watch.note("boundary.toggle");
    std::vector<LoopGap> told;
    QObject::connect(&watch, &LoopWatch::blocked, &watch,
                     [&told](const LoopGap& gap) { told.push_back(gap); });
    widget.takes = 120ms;
    QApplication::postEvent(&widget, new QEvent(QEvent::User));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !watch.gaps().empty(); }, 5000));
    const LoopGap& gap = watch.longest();
    EXPECT_GE(gap.milliseconds, 115);
    EXPECT_LT(gap.work, gap.milliseconds) << "it slept";
    EXPECT_EQ(gap.during, "boundary.toggle");
    EXPECT_EQ(gap.event, "User of Sluggish");
    EXPECT_EQ(told.size(), watch.gaps().size());
    EXPECT_TRUE(gap.text().endsWith("in User of Sluggish after boundary.toggle"))
        << gap.text().toStdString();
}

TEST(LoopWatch, CountsTheThreadsOwnWorkAndForgetsOnReset) {
    LoopWatch watch;
    QTest::qWait(20);
    watch.reset();
    EXPECT_EQ(watch.longest().milliseconds, 0);
    QTimer::singleShot(0, [] {
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < 90) {
        }
    });
    EXPECT_TRUE(QTest::qWaitFor([&] { return watch.longest().milliseconds >= 85; }, 5000));
    EXPECT_GT(watch.longest().work, 0);
    watch.reset();
    EXPECT_TRUE(watch.gaps().empty());
}

}  // namespace
}  // namespace kumite::studio

#include "loop_watch_test.moc"
