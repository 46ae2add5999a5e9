#include "studio/app/transport.h"

#include <algorithm>
#include <cmath>

namespace kumite::studio {

Transport::Transport(QObject* parent) : QObject(parent) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(16);
    connect(&timer_, &QTimer::timeout, this, &Transport::advance);
}

void Transport::setSpan(const TimeSpan& span) {
    setPlaying(false);
    span_ = span;
    playhead_ = span.begin;
    preview_.reset();
    loopIn_.reset();
    loopOut_.reset();
    Q_EMIT stateChanged();
    Q_EMIT moved();
}

void Transport::stretchSpan(const TimeSpan& span) {
    if (span.begin == span_.begin && span.end == span_.end) return;
    span_ = span;
    playhead_ = std::clamp(playhead_, span.begin, std::max(span.begin, span.end));
    Q_EMIT stateChanged();
    Q_EMIT moved();
}

void Transport::setPlayhead(double seconds) {
    const double inside = std::clamp(seconds, span_.begin, std::max(span_.begin, span_.end));
    if (inside == playhead_) return;
    playhead_ = inside;
    if (!preview_) Q_EMIT moved();
}

void Transport::setPreview(std::optional<double> seconds) {
    if (seconds == preview_) return;
    preview_ = seconds;
    Q_EMIT moved();
}

void Transport::setPlaying(bool playing) {
    if (playing == isPlaying()) return;
    if (playing) {
        // At the end it starts over.
        if (speed_ > 0 && playhead_ >= span_.end) setPlayhead(loopIn_.value_or(span_.begin));
        if (speed_ < 0 && playhead_ <= span_.begin) setPlayhead(loopOut_.value_or(span_.end));
        clock_.start();
        timer_.start();
    } else {
        timer_.stop();
    }
    Q_EMIT stateChanged();
}

void Transport::setSpeed(double speed) {
    const double size = std::clamp(std::abs(speed), 0.1, 4.0);
    speed_ = speed < 0 ? -size : size;
    Q_EMIT stateChanged();
}

void Transport::shuttle(int direction) {
    const bool same = isPlaying() && (speed_ > 0) == (direction > 0);
    setSpeed(same ? 2 * speed_ : direction);
    setPlaying(true);
}

void Transport::setLooping(bool looping) {
    looping_ = looping;
    Q_EMIT stateChanged();
}

void Transport::setLoop(std::optional<double> in, std::optional<double> out) {
    if (in && out && *out < *in) std::swap(in, out);
    loopIn_ = in;
    loopOut_ = out;
    Q_EMIT stateChanged();
}

void Transport::advance() {
    const double elapsed = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
    clock_.start();
    const double begin = looping_ ? loopIn_.value_or(span_.begin) : span_.begin;
    const double end = looping_ ? loopOut_.value_or(span_.end) : span_.end;
    const double next = playhead_ + elapsed * speed_;
    const bool past = speed_ > 0 ? next > end : next < begin;
    if (!past) {
        setPlayhead(next);
    } else if (looping_ && end > begin) {
        setPlayhead(speed_ > 0 ? begin : end);
    } else {
        setPlayhead(speed_ > 0 ? end : begin);
        setPlaying(false);
    }
}

}  // namespace kumite::studio
