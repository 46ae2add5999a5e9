#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "core/base/progress.h"

namespace kumite::studio {

/// Runs one kind of work beside the window. Only the latest job counts: starting one asks the
/// one before to stop, and whatever that still delivers is dropped. Belongs to the GUI thread.
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(QObject* parent = nullptr);
    /// Asks all jobs to stop and waits for them.
    ~JobRunner() override;

    /// Runs `work` on a thread of its own and then `done` with its result on this thread.
    /// `title` tells the user what is going on: "Reading two recordings".
    template <typename Work, typename Done>
    void start(const QString& title, Work work, Done done) {
        launch(title, [work = std::move(work), done = std::move(done)](const Progress& progress) {
            auto result = std::make_shared<decltype(work(progress))>(work(progress));
            return std::function<void()>([done, result] { done(std::move(*result)); });
        });
    }
    /// Drops the running job, if any.
    void cancel();
    bool isRunning() const { return running_; }

Q_SIGNALS:
    void started(const QString& title);
    void progressed(double fraction);
    /// The latest job is over: done, failed or cancelled.
    void finished();
    /// The latest job failed; one sentence for the user.
    void failed(const QString& sentence);

private:
    using Delivery = std::function<void()>;

    void launch(const QString& title, std::function<Delivery(const Progress&)> work);
    /// Has something done on this object's thread; for the jobs' threads.
    void post(std::function<void()> act);
    void customEvent(QEvent* event) override;
    void deliver(int number, const Delivery& delivery, const QString& error);

    struct Job {
        int number = 0;
        std::jthread thread;
    };

    std::vector<Job> jobs_;
    int latest_ = 0;
    bool running_ = false;
};

}  // namespace kumite::studio
