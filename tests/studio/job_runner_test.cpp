#include "studio/jobs/job_runner.h"

#include <gtest/gtest.h>

#include <QTest>

#include <atomic>
#include <thread>

#include "core/base/error.h"

namespace kumite::studio {
namespace {

using namespace std::chrono_literals;

void idle(const JobRunner& runner) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.isRunning(); }, 5000));
}

TEST(JobRunner, DeliversOnTheThreadThatAsked) {
    JobRunner runner;
    int result = 0;
    std::thread::id worker, receiver;
    runner.start(
        "work",
        [&worker](const Progress&) {
            worker = std::this_thread::get_id();
            return 7;
        },
        [&](int value) {
            result = value;
            receiver = std::this_thread::get_id();
        });
    EXPECT_TRUE(runner.isRunning());
    idle(runner);
    EXPECT_EQ(result, 7);
    EXPECT_EQ(receiver, std::this_thread::get_id());
    EXPECT_NE(worker, receiver);
}

TEST(JobRunner, LatestWinsAndStaleResultsAreDropped) {
    JobRunner runner;
    std::vector<int> results;
    std::atomic<bool> firstStopped = false;
    runner.start(
        "first",
        [&firstStopped](const Progress& progress) {
            while (!progress.stop.stop_requested())
                std::this_thread::sleep_for(1ms);
            firstStopped = true;
            return 1;
        },
        [&](int value) { results.push_back(value); });
    runner.start(
        "second", [](const Progress&) { return 2; }, [&](int value) { results.push_back(value); });
    idle(runner);
    QTest::qWait(50);
    EXPECT_TRUE(firstStopped);
    EXPECT_EQ(results, std::vector<int>{2});
}

TEST(JobRunner, FailureIsOneSentenceAndCancelIsSilent) {
    JobRunner runner;
    QStringList sentences;
    QObject::connect(&runner, &JobRunner::failed,
                     [&](const QString& sentence) { sentences.append(sentence); });
    runner.start(
        "fails", [](const Progress&) -> int { throw Error("The file is not there."); }, [](int) {});
    idle(runner);
    EXPECT_EQ(sentences, QStringList{"The file is not there."});
    runner.start(
        "cancelled",
        [](const Progress& progress) {
            while (true)
                progress.update(0.5);
            return 0;
        },
        [](int) { FAIL(); });
    runner.cancel();
    EXPECT_FALSE(runner.isRunning());
    QTest::qWait(50);
    EXPECT_EQ(sentences.size(), 1);
}

TEST(JobRunner, ReportsProgressInOrder) {
    JobRunner runner;
    std::vector<double> seen;
    QObject::connect(&runner, &JobRunner::progressed, [&](double share) { seen.push_back(share); });
    runner.start(
        "counts",
        [](const Progress& progress) {
            for (int i = 1; i <= 100; ++i)
                progress.update(i / 100.0);
            return 0;
        },
        [](int) {});
    idle(runner);
    ASSERT_FALSE(seen.empty());
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(JobRunner, HoldsWhenWorkIsReplacedAndCancelledInRapidTurn) {
    const std::vector<int> shared{1, 2, 3, 4};  // read by all, as recordings are
    JobRunner runner;
    std::vector<int> sums;
    int cancelled = 0;
    QObject::connect(&runner, &JobRunner::progressed, [](double) {});
    for (int i = 0; i < 200; ++i) {
        runner.start(
            QString::number(i),
            [&shared, i](const Progress& progress) {
                std::vector<int> own;
                for (int k = 0; k < 50; ++k) {
                    progress.update(k / 50.0);
                    own.push_back(shared[static_cast<std::size_t>(k) % shared.size()] + i);
                }
                return own;
            },
            [&](std::vector<int> own) { sums.push_back(own.front()); });
        if (i % 7 == 2) {
            runner.cancel();
            ++cancelled;
        }
        if (i % 5 == 0) QTest::qWait(1);
    }
    idle(runner);
    ASSERT_FALSE(sums.empty());
    EXPECT_EQ(sums.back(), 200) << "the latest is delivered, last";
    EXPECT_TRUE(std::is_sorted(sums.begin(), sums.end()));
    EXPECT_LE(sums.size(), static_cast<std::size_t>(200 - cancelled));
}

TEST(JobRunner, DestructionWaitsForTheThread) {
    std::atomic<bool> ended = false;
    {
        JobRunner runner;
        runner.start(
            "long",
            [&ended](const Progress& progress) {
                while (!progress.stop.stop_requested())
                    std::this_thread::sleep_for(1ms);
                ended = true;
                return 0;
            },
            [](int) {});
    }
    EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace kumite::studio
