// What a hand does to the key poses; each a step of the history.

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/motion/blend.h"
#include "studio/app/core_words.h"
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {

QString handleWord(Handle handle) {
    const std::string_view name = handleName(handle);
    return QString::fromLatin1(name.data(), qsizetype(name.size()))
        .replace(QLatin1Char('_'), QLatin1Char(' '));
}

}  // namespace

bool KeySession::attempt(const std::function<void()>& act) {
    try {
        act();
        return true;
    } catch (const std::exception& error) {
        Q_EMIT failed(coreWords(error.what()));
        return false;
    }
}

void KeySession::change(const QString& edit, const std::function<void(KeyDraft&)>& act) {
    if (library() == nullptr) return;
    KeyDraft draft = draft_;
    if (!attempt([&] { act(draft); })) return;
    session_.document().apply(Document::ProjectEdit(
        [&](const Project& project) { return setKeyDraft(project, draft, edit.toStdString()); }));
}

std::optional<Pose> KeySession::poseOfTake() const {
    const FighterAnalysis* fighter = session_.fighter(session_.activePlayer());
    if (fighter == nullptr || motions() == nullptr || !isOfProject()) return std::nullopt;
    for (const LibraryMotion& motion : motions()->motions) {
        if (motion.take != session_.take() || motion.player != session_.activePlayer()) continue;
        const double seconds = session_.shownFrame(session_.activePlayer()) / motion.sourceRate;
        return poseAt(motion.clip, std::min(seconds, motion.clip.seconds()));
    }
    return std::nullopt;
}

void KeySession::addKey() {
    if (library() == nullptr) return;
    const int frame = std::max(0, static_cast<int>(std::lround(frame_)));
    Pose pose;
    if (!draft_.track.keys.empty()) {
        pose = poseAt(draft_.track, frame);
    } else if (const auto recorded = poseOfTake()) {
        pose = *recorded;
        // Near the origin, where the next keys are made.
        pose.root.x() = pose.root.z() = 0;
    } else if (!motions()->motions.empty()) {
        pose = motions()->motions.front().clip.frames.front();
        pose.root.x() = pose.root.z() = 0;
    }
    change(tr("Add a key at frame %1").arg(frame), [&](KeyDraft& draft) {
        draft.track = withKey(std::move(draft.track), {frame, pose, Easing::Smooth});
    });
    choose(frame);
}

void KeySession::takePose() {
    if (const auto recorded = poseOfTake())
        usePose(*recorded, tr("Take the pose of the recording"));
}

void KeySession::usePose(const Pose& pose, const QString& edit) {
    if (library() == nullptr) return;
    const int frame = key_.value_or(std::max(0, static_cast<int>(std::lround(frame_))));
    change(edit, [&](KeyDraft& draft) {
        KeyPose key{frame, pose, Easing::Smooth};
        // Where the keys are, not where the recording was.
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        if (!draft.track.keys.empty()) place = poseAt(draft.track, frame).root;
        if (const auto index = draft.track.find(frame))
            key.easing = draft.track.keys[static_cast<std::size_t>(*index)].easing;
        key.pose.root.x() = place.x();
        key.pose.root.z() = place.z();
        draft.track = withKey(std::move(draft.track), std::move(key));
    });
    choose(frame);
}

void KeySession::removeKey() {
    if (!key_) return;
    const int frame = *key_;
    change(tr("Remove the key at frame %1").arg(frame),
           [&](KeyDraft& draft) { draft.track = withoutKey(std::move(draft.track), frame); });
}

void KeySession::moveKey(int from, int to) {
    if (from == to || to < 0) return;
    if (draft_.track.find(to)) {
        Q_EMIT session_.hinted(tr("A key stands at frame %1 already.").arg(to));
        return;
    }
    change(tr("Move the key to frame %1").arg(to),
           [&](KeyDraft& draft) { draft.track = withMovedKey(std::move(draft.track), from, to); });
    choose(to);
}

void KeySession::shiftKeys(int from, int to) {
    if (from == to || to < 0) return;
    change(tr("Move the key and later ones to frame %1").arg(to), [&](KeyDraft& draft) {
        draft.track = withShiftedKeys(std::move(draft.track), from, to);
    });
    choose(draft_.track.find(to) ? to : from);
}

void KeySession::retime(double factor) {
    if (!key_ || factor == 1) return;
    change(tr("Later keys %1 times as far").arg(numberText(factor)),
           [&](KeyDraft& draft) { draft.track = retimed(std::move(draft.track), *key_, factor); });
}

void KeySession::copyKey() {
    if (!key_) return;
    const int to = std::max(0, static_cast<int>(std::lround(frame_)));
    // The playhead stands on the chosen key: its copy comes half a second after the last one.
    const int place = to != *key_ ? to : lastFrame() + static_cast<int>(rate() / 2);
    change(tr("Copy the key to frame %1").arg(place), [&](KeyDraft& draft) {
        draft.track = withCopiedKey(std::move(draft.track), *key_, place);
    });
    choose(place);
}

void KeySession::mirrorKey() {
    if (!key_) return;
    change(tr("Mirror the key"), [&](KeyDraft& draft) {
        KeyPose& key = draft.track.keys[static_cast<std::size_t>(*draft.track.find(*key_))];
        const Eigen::Vector3d place = key.pose.root;
        key.pose = mirrored(*draft.track.rig, key.pose);
        key.pose.root = place;
    });
}

void KeySession::setEasing(Easing easing) {
    if (!key_) return;
    change(tr("Change the way to the next key"), [&](KeyDraft& draft) {
        draft.track = withEasing(std::move(draft.track), *key_, easing);
    });
}

void KeySession::clear() {
    change(tr("Remove all keys"), [](KeyDraft& draft) { draft.track.keys.clear(); });
}

void KeySession::setHandle(Handle handle) {
    if (handle != handle_) session_.document().endGesture();
    handle_ = handle;
    Q_EMIT chosen();
}

void KeySession::setPinned(Handle handle, bool pinned) {
    pins_[handle] = pinned;
    Q_EMIT chosen();
}

void KeySession::drag(Handle handle, const Eigen::Vector3d& place) {
    if (!isEditable()) return;
    const KeyPose& key = draft_.track.keys[static_cast<std::size_t>(*draft_.track.find(*key_))];
    Pins pins = pins_;
    pins[handle] = false;
    const DragResult result = dragged(*draft_.track.rig, key.pose, handle, place, pins);
    dragged_ = result.pose;
    missing_ = result.missing;
    dragEdit_ = tr("Drag the %1").arg(handleWord(handle));
    show();
}

void KeySession::setJoint(std::optional<int> joint) {
    if (joint == joint_) return;
    joint_ = joint;
    Q_EMIT chosen();
}

void KeySession::stepJoint(int direction) {
    const std::vector<int> all = joints();
    const auto count = static_cast<int>(all.size()) + 1;  // none comes before the first
    const int now =
        joint_ ? static_cast<int>(std::find(all.begin(), all.end(), *joint_) - all.begin()) + 1 : 0;
    const int next = ((now + direction) % count + count) % count;
    setJoint(next == 0 ? std::nullopt : std::optional(all[static_cast<std::size_t>(next - 1)]));
}

std::vector<int> KeySession::joints() const {
    std::vector<int> all;
    for (int j = 0; draft_.track.rig && j < draft_.track.rig->jointCount(); ++j) {
        if (!draft_.track.rig->joint(j).isEndSite) all.push_back(j);
    }
    return all;
}

QString KeySession::jointName(int joint) const {
    const Rig& rig = *draft_.track.rig;
    for (const Role role : allRoles()) {
        if (rig.roles[role] == joint) return roleWords(role);
    }
    return QString::fromStdString(rig.joint(joint).name);
}

void KeySession::showTurn(const Eigen::Quaterniond& turn) {
    const KeyPose& key = draft_.track.keys[static_cast<std::size_t>(*draft_.track.find(*key_))];
    dragged_ = withJointTurn(*draft_.track.rig, key.pose, *joint_, turn, pins_).pose;
    dragEdit_ = tr("Turn the %1").arg(jointName(*joint_));
    show();
}

void KeySession::turn(int axis, double radians) {
    if (!isEditable() || !joint_) return;
    const KeyPose& key = draft_.track.keys[static_cast<std::size_t>(*draft_.track.find(*key_))];
    const Eigen::Quaterniond more(Eigen::AngleAxisd(radians, Eigen::Vector3d::Unit(axis)));
    showTurn(more * key.pose.turns[static_cast<std::size_t>(*joint_)]);
}

void KeySession::turnTo(const Eigen::Quaterniond& turn) {
    if (!isEditable() || !joint_) return;
    showTurn(turn);
    release();
}

void KeySession::release() {
    if (!dragged_ || !key_) return;
    const Pose pose = *dragged_;
    missing_ = 0;
    change(dragEdit_, [&](KeyDraft& draft) {
        draft.track.keys[static_cast<std::size_t>(*draft.track.find(*key_))].pose = pose;
    });
    dragged_.reset();
    show();
}

void KeySession::cancelDrag() {
    dragged_.reset();
    missing_ = 0;
    show();
}

void KeySession::nudge(const Eigen::Vector3d& way) {
    if (!isEditable() || pose() == nullptr) return;
    const auto at = handlePoint(*draft_.track.rig, *pose(), handle_);
    if (!at) return;
    drag(handle_, *at + way);
    const Pose pose = *dragged_;
    missing_ = 0;
    KeyDraft draft = draft_;
    draft.track.keys[static_cast<std::size_t>(*draft.track.find(*key_))].pose = pose;
    const QString edit = tr("Move the %1 a little").arg(handleWord(handle_));
    session_.document().applyLive(
        QStringLiteral("nudge %1 of key %2").arg(static_cast<int>(handle_)).arg(*key_),
        [&](const Project& project) { return setKeyDraft(project, draft, edit.toStdString()); });
    dragged_.reset();
    show();
}

void KeySession::place(Handle handle, const Eigen::Vector3d& place) {
    drag(handle, place);
    handle_ = handle;
    release();
}

}  // namespace kumite::studio
