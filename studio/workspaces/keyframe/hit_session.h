#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/editing/hit_region.h"
#include "core/project/hit_draft.h"
#include "studio/jobs/job_runner.h"
#include "studio/workspaces/made_motion.h"

namespace kumite::studio {

class KeySession;

/// The hit tool of the Keyframe workspace: a strike of the library that is made to hit a target,
/// live while the target is dragged. Strike and target are the project's draft: every change of
/// them is a step of the history. The space of a strike is made beside the window.
class HitSession : public QObject {
    Q_OBJECT

public:
    explicit HitSession(KeySession& keys, QObject* parent = nullptr);

    JobRunner& jobs() { return jobs_; }
    bool isOn() const { return on_; }
    void setOn(bool on);

    /// Aspects of the vocabulary that the library's labels have as strikes, and clips that strike.
    const std::vector<std::string>& strikes() const { return strikes_; }
    QString nameOf(const std::string& strike) const;
    const std::string& strike() const { return strike_; }
    /// It hits where its examples do, until a hand draws the target elsewhere.
    void setStrike(const std::string& strike);
    /// Why there is nothing to strike with; else empty.
    QString problem() const { return problem_; }

    const StrikeSpace* space() const { return ready_ ? &ready_->space : nullptr; }
    /// What partial blending reaches.
    const Box& reach() const { return ready_->reach; }
    /// In the striker's frame, metres.
    const Eigen::Vector3d& target() const { return target_; }
    void setTarget(const Eigen::Vector3d& target);
    /// Draws the target there; `release` makes it a step of the history, `cancelDrag` takes it
    /// back.
    void drag(const Eigen::Vector3d& target);
    void release();
    void cancelDrag();
    /// What the opponent can be hit at.
    static std::span<const Role> aims();
    std::optional<Role> aim() const { return draft_.aim; }
    /// Aims at a joint of the opponent, who stands as the recording's playhead shows it; nothing:
    /// at the place where the target is.
    void setAim(std::optional<Role> aim);
    double distance() const { return draft_.distance; }
    void setDistance(double metres);
    /// The opponent in the striker's frame; null while nothing of it is aimed at.
    const Pose* opponent() const { return opponent_ ? &*opponent_ : nullptr; }
    const std::optional<HitMotion>& motion() const { return motion_; }
    MadeMotion madeMotion() const;

    /// The shown pose; null where there is none.
    const Pose* pose() const { return shown_ ? &*shown_ : nullptr; }
    double seconds() const { return seconds_; }  ///< of the motion, shown now
    void seek(double seconds);
    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);

Q_SIGNALS:
    void changed();
    void moved();
    void failed(const QString& sentence);

private:
    struct Ready {
        StrikeSpace space;
        Box reach;
    };

    void takeLibrary();
    void readDraft();
    Eigen::Vector3d wantedTarget() const;
    void placeOpponent();
    void change(const QString& edit, const HitDraft& draft);
    void prepare();
    void solve();
    void advance();
    void show();

    KeySession& keys_;
    JobRunner jobs_;
    HitDraft draft_;
    bool dragging_ = false;
    std::optional<Pose> opponent_;
    QTimer timer_;
    QElapsedTimer clock_;
    bool on_ = false;
    std::vector<std::string> strikes_;
    std::string strike_;
    QString problem_;
    std::shared_ptr<const Ready> ready_;
    Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
    std::optional<HitMotion> motion_;
    double seconds_ = 0;
    std::optional<Pose> shown_;
};

}  // namespace kumite::studio
