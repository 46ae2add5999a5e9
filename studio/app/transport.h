#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>

#include "core/project/analysis.h"

namespace kumite::studio {

/// The playhead and how it runs: seconds on the take's clock, forward or backward, in a loop or
/// to the end.
class Transport : public QObject {
    Q_OBJECT

public:
    explicit Transport(QObject* parent = nullptr);

    TimeSpan span() const { return span_; }
    /// A new take: the playhead goes to its begin, the loop range is forgotten.
    void setSpan(const TimeSpan& span);
    /// The same take became longer or shorter: playhead, loop and speed stay.
    void stretchSpan(const TimeSpan& span);

    double playhead() const { return playhead_; }
    void setPlayhead(double seconds);
    /// While a boundary is dragged the views show the moment where it would stand.
    void setPreview(std::optional<double> seconds);
    /// The moment that the views show: the preview, else the playhead.
    double shownTime() const { return preview_.value_or(playhead_); }

    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);
    void toggle() { setPlaying(!isPlaying()); }
    /// 1 = as recorded; negative runs backward. 0.1 … 4 either way.
    double speed() const { return speed_; }
    void setSpeed(double speed);
    /// J and L: plays in that direction; the same direction again doubles the speed.
    void shuttle(int direction);

    bool isLooping() const { return looping_; }
    void setLooping(bool looping);
    std::optional<double> loopIn() const { return loopIn_; }
    std::optional<double> loopOut() const { return loopOut_; }
    void setLoop(std::optional<double> in, std::optional<double> out);

Q_SIGNALS:
    /// The shown moment changed.
    void moved();
    /// Playing, speed or loop changed.
    void stateChanged();

private:
    void advance();

    TimeSpan span_;
    double playhead_ = 0;
    std::optional<double> preview_;
    double speed_ = 1;
    bool looping_ = false;
    std::optional<double> loopIn_;
    std::optional<double> loopOut_;
    QTimer timer_;
    QElapsedTimer clock_;
};

}  // namespace kumite::studio
