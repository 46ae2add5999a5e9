#include "studio/jobs/job_runner.h"

#include <QCoreApplication>
#include <QEvent>

#include <algorithm>
#include <atomic>
#include <new>
#include <utility>

#include "core/base/error.h"
#include "studio/app/core_words.h"
#include "studio/jobs/queue_edge.h"

namespace kumite::studio {

namespace {

const auto kForRunner = static_cast<QEvent::Type>(QEvent::registerEventType());

/// What a job's thread wants done on the runner's.
struct ForRunner : QEvent {
    explicit ForRunner(std::function<void()> what) : QEvent(kForRunner), act(std::move(what)) {}

    std::function<void()> act;
};

}  // namespace

JobRunner::JobRunner(QObject* parent) : QObject(parent) {}

JobRunner::~JobRunner() {
    for (Job& job : jobs_)
        job.thread.request_stop();
    jobs_.clear();
}

void JobRunner::cancel() {
    if (!running_) return;
    jobs_.back().thread.request_stop();
    ++latest_;
    running_ = false;
    Q_EMIT finished();
}

void JobRunner::launch(const QString& title, std::function<Delivery(const Progress&)> work) {
    for (Job& job : jobs_)
        job.thread.request_stop();
    const int number = ++latest_;
    running_ = true;
    Q_EMIT started(title);

    auto run = [this, number, work = std::move(work)](std::stop_token stop) {
        Progress progress;
        progress.stop = std::move(stop);
        auto shown = std::make_shared<std::atomic<int>>(0);
        progress.report = [this, number, shown](double fraction) {
            const int percent = static_cast<int>(fraction * 100);
            if (shown->exchange(percent) == percent) return;
            post([this, number, fraction] {
                if (number == latest_ && running_) Q_EMIT progressed(fraction);
            });
        };
        Delivery delivery;
        QString error;
        try {
            delivery = work(progress);
        } catch (const Cancelled&) {
            error.clear();
        } catch (const std::bad_alloc&) {
            error = tr("There is not enough memory for this.");
        } catch (const std::exception& exception) {
            error = coreWords(exception.what());
        }
        post([this, number, delivery, error] { deliver(number, delivery, error); });
    };
    jobs_.push_back({number, std::jthread(std::move(run))});
}

void JobRunner::post(std::function<void()> act) {
    auto event = std::make_unique<ForRunner>(std::move(act));
    putsIntoQueue();
    QCoreApplication::postEvent(this, event.release());
}

void JobRunner::customEvent(QEvent* event) {
    takenFromQueue();
    if (event->type() == kForRunner) static_cast<ForRunner*>(event)->act();
}

void JobRunner::deliver(int number, const Delivery& delivery, const QString& error) {
    std::erase_if(jobs_, [number](const Job& job) { return job.number == number; });
    if (number != latest_ || !running_) return;
    running_ = false;
    Q_EMIT finished();
    if (delivery) {
        delivery();
    } else if (!error.isEmpty()) {
        Q_EMIT failed(error);
    }
}

}  // namespace kumite::studio
