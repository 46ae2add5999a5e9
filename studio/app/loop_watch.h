#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include <vector>

namespace kumite::studio {

/// A time in which the event loop did not come round: whoever pressed a key then had to wait.
struct LoopGap {
    double milliseconds = 0;
    /// What the thread itself worked in it; the rest it waited, or other programs had the
    /// processor.
    double work = 0;
    QString during;  ///< what was noted before: a command, a line of a script
    QString event;   ///< the event that took the most of it: "Paint of TimelineView"

    /// One line for people.
    QString text() const;
};

/// Watches the event loop of the thread that made it.
class LoopWatch : public QObject {
    Q_OBJECT

public:
    /// A window answers within a blink.
    static constexpr double kBlink = 50;  // milliseconds

    explicit LoopWatch(QObject* parent = nullptr);
    ~LoopWatch() override;

    /// What goes on from now on.
    void note(const QString& what) { during_ = what; }
    /// The longest gap since the last `reset`, however short.
    const LoopGap& longest() const { return longest_; }
    /// Those above a blink.
    const std::vector<LoopGap>& gaps() const { return gaps_; }
    void reset();

Q_SIGNALS:
    /// A gap above a blink is over.
    void blocked(const LoopGap& gap);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void beat();
    void endEvent(qint64 now);

    struct Seen {
        const char* receiver = nullptr;  ///< name of its class
        int type = 0;
        qint64 nanoseconds = 0;  ///< begin, or how long
    };

    QTimer timer_;
    QElapsedTimer clock_;
    qint64 lastBeat_ = 0;
    qint64 lastWork_ = 0;
    Seen running_, slowest_;
    QString during_;
    LoopGap longest_;
    std::vector<LoopGap> gaps_;
};

}  // namespace kumite::studio
