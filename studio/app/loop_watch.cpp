#include "studio/app/loop_watch.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaEnum>

#include <algorithm>
#include <ctime>

namespace kumite::studio {

namespace {

constexpr int kBeat = 2;  // milliseconds

/// Processor time of this thread, nanoseconds.
qint64 threadWork() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1'000'000'000LL * time.tv_sec + time.tv_nsec;
}

QString eventName(const char* receiver, int type) {
    const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
    QString whose = QString::fromLatin1(receiver);
    whose = whose.mid(whose.lastIndexOf(QLatin1Char(':')) + 1);
    return QStringLiteral("%1 of %2")
        .arg(name ? QString::fromLatin1(name) : QString::number(type), whose);
}

}  // namespace

QString LoopGap::text() const {
    QString line =
        QStringLiteral("%1 ms (work %2 ms)").arg(milliseconds, 0, 'f', 1).arg(work, 0, 'f', 1);
    if (!event.isEmpty()) line += QStringLiteral(" in ") + event;
    if (!during.isEmpty()) line += QStringLiteral(" after ") + during;
    return line;
}

LoopWatch::LoopWatch(QObject* parent) : QObject(parent) {
    clock_.start();
    reset();
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kBeat);
    connect(&timer_, &QTimer::timeout, this, &LoopWatch::beat);
    timer_.start();
    QCoreApplication::instance()->installEventFilter(this);
}

LoopWatch::~LoopWatch() = default;

void LoopWatch::reset() {
    longest_ = {};
    gaps_.clear();
    running_ = slowest_ = {};
    lastBeat_ = clock_.nsecsElapsed();
    lastWork_ = threadWork();
}

void LoopWatch::endEvent(qint64 now) {
    const qint64 took = now - running_.nanoseconds;
    if (running_.receiver != nullptr && took > slowest_.nanoseconds) {
        slowest_ = {running_.receiver, running_.type, took};
    }
}

bool LoopWatch::eventFilter(QObject* watched, QEvent* event) {
    // An event lasts until the next begins; one within another is told apart from it.
    const qint64 now = clock_.nsecsElapsed();
    endEvent(now);
    running_ = {watched->metaObject()->className(), event->type(), now};
    return false;
}

void LoopWatch::beat() {
    const qint64 now = clock_.nsecsElapsed();
    const qint64 work = threadWork();
    endEvent(now);
    LoopGap gap;
    gap.milliseconds = std::max(0.0, 1e-6 * double(now - lastBeat_) - kBeat);
    if (gap.milliseconds > std::max(longest_.milliseconds, 1.0) || gap.milliseconds > kBlink) {
        gap.work = 1e-6 * double(work - lastWork_);
        gap.during = during_;
        if (slowest_.receiver != nullptr) gap.event = eventName(slowest_.receiver, slowest_.type);
        if (gap.milliseconds > longest_.milliseconds) longest_ = gap;
        if (gap.milliseconds > kBlink) {
            gaps_.push_back(gap);
            Q_EMIT blocked(gap);
        }
    }
    running_ = slowest_ = {};
    lastBeat_ = now;
    lastWork_ = work;
}

}  // namespace kumite::studio
