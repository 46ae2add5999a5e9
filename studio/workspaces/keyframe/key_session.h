#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/editing/pose_handles.h"
#include "core/project/key_draft.h"
#include "studio/app/session.h"
#include "studio/workspaces/made_motion.h"

namespace kumite::studio {

/// What key poses are looked up in: the project's takes and clips with the features of all poses.
struct KeySource {
    Project made;  ///< what it was made of, without drafts
    std::shared_ptr<const KeyLibrary> library;
    QString whyNothing;  ///< what is missing; else empty
};

/// A motion that was made of the keys.
struct KeyMotion {
    std::vector<PoseMatch> found;  ///< for the whole body, the best first
    std::array<std::vector<PoseMatch>, kBodyPartCount> foundOfPart;
    AssemblyPlan plan;
    Assembly assembly;
    Assembly direct;  ///< the same without any adjustment
};

/// What the Keyframe workspace works on. The keys are the project's draft: every change of them is
/// a step of the history. Library and motion are computed beside the window; the latest wins.
class KeySession : public QObject {
    Q_OBJECT

public:
    explicit KeySession(Session& session, QObject* parent = nullptr);

    Session& session() { return session_; }
    JobRunner& jobs() { return jobs_; }
    JobRunner& making() { return making_; }
    JobRunner& writing() { return writing_; }
    /// Prepares and makes only while somebody looks.
    void setActive(bool active);
    bool isActive() const { return active_; }
    bool isPreparing() const { return jobs_.isRunning() || due_.isActive(); }

    /// Null until it was prepared for the first time, or where there is nothing to make it of.
    const KeyLibrary* library() const { return source_ ? source_->library.get() : nullptr; }
    std::shared_ptr<const MotionLibrary> motions() const;
    QString whyNothing() const { return source_ ? source_->whyNothing : QString(); }
    /// "punch 0:01.2 to 0:02.0".
    QString placeOf(const PoseMatch& match) const;

    const KeyDraft& draft() const { return draft_; }
    /// The motion of the draft; null where there is none (yet).
    const KeyMotion* motion() const { return motion_.get(); }
    bool isCurrent() const { return motion_ != nullptr && current_; }
    /// Why the keys give no motion; else empty.
    QString problem() const { return problem_; }
    MadeMotion madeMotion() const;

    // Edits; one step of the history each.
    /// A key at the playhead: the pose that the keys have there; the first is a pose of the take.
    void addKey();
    /// The pose of the active fighter at the take's playhead, where the key stands.
    void takePose();
    /// A pose where the chosen key stands; without one a new key at the playhead.
    void usePose(const Pose& pose, const QString& edit);
    void removeKey();
    void moveKey(int from, int to);
    /// The same of a key and all later ones.
    void shiftKeys(int from, int to);
    /// All later keys that many times as far from the chosen one.
    void retime(double factor);
    void copyKey();
    void mirrorKey();
    void setEasing(Easing easing);
    void clear();
    void change(const QString& edit, const std::function<void(KeyDraft&)>& act);

    /// The chosen key's frame.
    std::optional<int> key() const { return key_; }
    void choose(std::optional<int> frame);
    void chooseNext(int direction);

    // The pose of the chosen key, by hand.
    Handle handle() const { return handle_; }
    void setHandle(Handle handle);
    const Pins& pins() const { return pins_; }
    void setPinned(Handle handle, bool pinned);
    /// The joint that is turned by rings and numbers.
    std::optional<int> joint() const { return joint_; }
    void setJoint(std::optional<int> joint);
    /// The joint after or before the chosen one; behind the last there is none.
    void stepJoint(int direction);
    /// What can be turned, from the root on, and how it is called.
    std::vector<int> joints() const;
    QString jointName(int joint) const;
    /// Turns the chosen joint from where the key has it, about an axis of its parent (0 to 2);
    /// `release` makes it a step of the history.
    void turn(int axis, double radians);
    /// Gives the chosen joint a local rotation, within its limits, as a step of the history.
    void turnTo(const Eigen::Quaterniond& turn);
    /// Draws the handle to a place; `release` makes it a step of the history.
    void drag(Handle handle, const Eigen::Vector3d& place);
    void release();
    /// Leaves what is being drawn as it was.
    void cancelDrag();
    /// The chosen handle a little way on; one after the other they are one step.
    void nudge(const Eigen::Vector3d& way);
    /// Draws a handle to exactly that place, as a step of the history.
    void place(Handle handle, const Eigen::Vector3d& place);
    /// How far the dragged handle stayed behind the hand, metres.
    double missing() const { return missing_; }

    /// The keys themselves, or the motion made of them.
    bool showsMotion() const { return showsMotion_; }
    void setShowsMotion(bool motion);

    /// The keys before and after what is shown as ghosts.
    bool showsNeighbours() const { return showsNeighbours_; }
    void setShowsNeighbours(bool on);
    std::vector<Pose> neighbours() const;
    /// Beside the motion what it would be without adjustment.
    bool showsDirect() const { return showsDirect_; }
    void setShowsDirect(bool on);
    std::optional<Pose> directPose() const;

    /// The shown pose; null where there is none.
    const Pose* pose() const { return shown_ ? &*shown_ : nullptr; }
    /// Whether the shown pose is the chosen key's, which can be dragged.
    bool isEditable() const;
    double frame() const { return frame_; }  ///< of the keys' timeline
    double rate() const { return draft_.track.rate > 0 ? draft_.track.rate : 60; }
    int firstFrame() const;
    int lastFrame() const;
    void seek(double frame);
    void step(int frames);
    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);

Q_SIGNALS:
    /// Another library, or none.
    void libraryChanged();
    void draftChanged();
    void motionChanged();
    /// Another key or handle is chosen, or pins changed.
    void chosen();
    /// Another moment or pose is shown.
    void moved();
    void stateChanged();
    void failed(const QString& sentence);

private:
    void follow();
    /// Whether the library is that of the project as it is.
    bool isOfProject() const;
    void prepare();
    void readDraft();
    void make();
    void showTurn(const Eigen::Quaterniond& turn);
    bool attempt(const std::function<void()>& act);
    std::optional<Pose> poseOfTake() const;
    void advance();
    void show();

    Session& session_;
    JobRunner jobs_, making_, writing_;
    QTimer due_, timer_;
    QElapsedTimer clock_;
    bool active_ = false;
    std::shared_ptr<const KeySource> source_;
    KeyDraft draft_;
    std::string draftText_;
    std::shared_ptr<const KeyMotion> motion_;
    bool current_ = false;
    QString problem_;
    std::optional<int> key_;
    Handle handle_ = Handle::RightHand;
    Pins pins_ = feetPinned();
    std::optional<int> joint_;
    QString dragEdit_;             ///< what the history says of a drag
    std::optional<Pose> dragged_;  ///< the chosen key's pose while a hand draws at it
    double missing_ = 0;
    bool showsMotion_ = false, showsNeighbours_ = false, showsDirect_ = false;
    double frame_ = 0;
    std::optional<Pose> shown_;
};

}  // namespace kumite::studio
