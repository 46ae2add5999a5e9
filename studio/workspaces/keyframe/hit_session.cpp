#include "studio/workspaces/keyframe/hit_session.h"

#include <algorithm>
#include <exception>
#include <numbers>
#include <utility>

#include "core/editing/pose_handles.h"
#include "core/motion/blend.h"
#include "core/project/library_strikes.h"
#include "studio/app/core_words.h"
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

namespace {
constexpr int kTick = 16;  // milliseconds
}

HitSession::HitSession(KeySession& keys, QObject* parent) : QObject(parent), keys_(keys) {
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kTick);
    connect(&timer_, &QTimer::timeout, this, &HitSession::advance);
    connect(&keys_, &KeySession::libraryChanged, this, &HitSession::takeLibrary);
    connect(&keys_, &KeySession::stateChanged, this, [this, active = false]() mutable {
        if (active == keys_.isActive()) return;
        active = keys_.isActive();
        if (!active) setPlaying(false);
        if (active && !strikes_.empty()) readDraft();
    });
    connect(&keys_.session().document(), &Document::changed, this, [this] {
        if (keys_.isActive() && !strikes_.empty() && !dragging_) readDraft();
    });
    connect(&jobs_, &JobRunner::failed, this, &HitSession::failed);
    connect(&jobs_, &JobRunner::started, this, &HitSession::changed);
    connect(&jobs_, &JobRunner::finished, this, &HitSession::changed);
}

void HitSession::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    if (on_) {
        keys_.setPlaying(false);
        if (strikes_.empty()) {
            takeLibrary();
        } else if (ready_ == nullptr) {
            prepare();
        }
    } else {
        setPlaying(false);
    }
    Q_EMIT changed();
    show();
}

QString HitSession::nameOf(const std::string& strike) const {
    const Vocabulary& vocabulary = *keys_.session().document().project().labelling.vocabulary;
    const auto aspect = vocabulary.find(strike);
    return aspect ? vocabularyWords(vocabulary[*aspect].name) : QString::fromStdString(strike);
}

/// Aspects that strike and that some action has; without labels whole clips and takes.
void HitSession::takeLibrary() {
    jobs_.cancel();
    ready_.reset();
    motion_.reset();
    strikes_.clear();
    const auto library = keys_.motions();
    if (library != nullptr) {
        strikes_ = strikesIn(*library, *keys_.session().document().project().labelling.vocabulary);
        if (strikes_.empty()) {
            for (const LibraryMotion& motion : library->motions)
                strikes_.push_back(motion.name);
        }
    }
    strike_.clear();
    readDraft();
    Q_EMIT changed();
}

void HitSession::readDraft() {
    try {
        draft_ = hitDraftOf(keys_.session().document().project());
    } catch (const std::exception& error) {
        draft_ = {};
        Q_EMIT failed(coreWords(error.what()));
    }
    opponent_ = opponentOf(draft_);
    const bool isKnown =
        std::find(strikes_.begin(), strikes_.end(), draft_.strike) != strikes_.end();
    const std::string strike = isKnown            ? draft_.strike
                               : strikes_.empty() ? std::string()
                                                  : strikes_.front();
    if (strike != strike_) {
        strike_ = strike;
        ready_.reset();
        motion_.reset();
        if (on_) prepare();
    } else if (ready_ != nullptr && target_ != wantedTarget()) {
        target_ = wantedTarget();
        setPlaying(false);
        solve();
    }
    Q_EMIT changed();
    show();
}

std::span<const Role> HitSession::aims() {
    static constexpr Role kAims[] = {Role::Head,      Role::Neck,         Role::Chest,
                                     Role::Pelvis,    Role::LeftShoulder, Role::RightShoulder,
                                     Role::LeftElbow, Role::RightElbow,   Role::LeftHip,
                                     Role::RightHip,  Role::LeftKnee,     Role::RightKnee};
    return kAims;
}

/// Facing the striker at the distance; in the pose that the recording's playhead shows of the other
/// player, of the only one where there is none.
std::optional<Pose> HitSession::opponentOf(const HitDraft& draft) const {
    const auto library = keys_.motions();
    if (!draft.aim || library == nullptr || library->motions.empty()) return std::nullopt;
    const Session& session = keys_.session();
    const LibraryMotion* source = &library->motions.front();
    int player = 0;
    for (const LibraryMotion& motion : library->motions) {
        if (motion.take != session.take()) continue;
        source = &motion;
        player = motion.player;
        if (player != session.activePlayer()) break;
    }
    const bool isShown = source->take >= 0 && session.fighter(player) != nullptr;
    const double seconds = isShown ? session.shownFrame(player) / source->sourceRate : 0.0;
    Pose pose = poseAt(source->clip, std::min(seconds, source->clip.seconds()));
    const double turn =
        std::numbers::pi - headingOf(*library->rig, pose).value_or(std::numbers::pi);
    pose.turns[0] = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()) * pose.turns[0];
    const auto pelvis = handlePoint(*library->rig, pose, Handle::Hips);
    if (!pelvis) return std::nullopt;
    pose.root += Eigen::Vector3d(-pelvis->x(), 0, draft.distance - pelvis->z());
    return pose;
}

void HitSession::setAim(std::optional<Role> aim) {
    HitDraft draft = draft_;
    draft.strike = strike_;
    if (!aim && ready_ != nullptr) draft.target = target_;
    draft.aim = aim;
    draft.target = targetOf(draft);  // for whoever does not know the playhead
    change(aim ? tr("Aim at the opponent") : tr("Aim at a place"), draft);
}

void HitSession::setDistance(double metres) {
    HitDraft draft = draft_;
    draft.distance = metres;
    draft.target = targetOf(draft);
    change(tr("Opponent %1 m away").arg(numberText(metres, 2)), draft);
}

std::optional<Eigen::Vector3d> HitSession::targetOf(const HitDraft& draft) const {
    const auto opponent = opponentOf(draft);
    if (!opponent) return draft.target;
    const Rig& rig = *keys_.motions()->rig;
    const auto joint = rig.roles[*draft.aim];
    if (!joint) return draft.target;
    JointFrames frames;
    jointFrames(rig, *opponent, frames);
    return frames.positions[static_cast<std::size_t>(*joint)];
}

Eigen::Vector3d HitSession::wantedTarget() const {
    const StrikeSpace& space = ready_->space;
    return targetOf(draft_).value_or(
        space.examples[static_cast<std::size_t>(space.reference)].point);
}

void HitSession::change(const QString& edit, const HitDraft& draft) {
    keys_.session().document().apply(Document::ProjectEdit(
        [&](const Project& project) { return setHitDraft(project, draft, edit.toStdString()); }));
}

void HitSession::setStrike(const std::string& strike) {
    if (strike == strike_) return;
    HitDraft draft;
    draft.strike = strike;
    change(tr("Strike with %1").arg(nameOf(strike)), draft);
}

void HitSession::prepare() {
    problem_.clear();
    const auto library = keys_.motions();
    if (library == nullptr || strike_.empty()) return;
    struct Result {
        std::shared_ptr<const Ready> ready;
        QString problem;
    };
    jobs_.start(
        tr("Aligning the strikes"),
        [library, strike = strike_](const Progress& progress) {
            Result result;
            try {
                StrikeRequest request;
                request.strike = strike;
                auto ready = std::make_shared<Ready>();
                ready->space = strikeSpace(strikesOf(*library, request), {}, progress.part(0, 0.6));
                ready->reach = extendedBox(ready->space, {}, 0.05, 0.3, progress.part(0.6, 1));
                result.ready = std::move(ready);
            } catch (const Cancelled&) {
                throw;
            } catch (const std::exception& error) {
                result.problem = coreWords(error.what());
            }
            return result;
        },
        [this](Result result) {
            ready_ = std::move(result.ready);
            problem_ = result.problem;
            if (ready_ != nullptr) {
                target_ = wantedTarget();
                solve();
            }
            Q_EMIT changed();
            show();
        });
}

void HitSession::setTarget(const Eigen::Vector3d& target) {
    drag(target);
    release();
}

void HitSession::drag(const Eigen::Vector3d& target) {
    if (ready_ == nullptr) return;
    dragging_ = true;
    target_ = target;
    target_.y() = std::clamp(target_.y(), 0.0, 2.5);
    setPlaying(false);
    solve();
    Q_EMIT changed();
    show();
}

void HitSession::release() {
    if (!std::exchange(dragging_, false)) return;
    HitDraft draft = draft_;
    draft.strike = strike_;
    draft.target = target_;
    draft.aim.reset();
    change(tr("Move the target"), draft);
}

void HitSession::cancelDrag() {
    if (!std::exchange(dragging_, false) || ready_ == nullptr) return;
    target_ = wantedTarget();
    solve();
    Q_EMIT changed();
    show();
}

/// A few milliseconds: at once, so that the figure follows the hand.
void HitSession::solve() {
    motion_.reset();
    if (ready_ == nullptr) return;
    try {
        motion_ = hitTarget(ready_->space, target_);
        seconds_ = motion_->hit / motion_->clip.rate;
    } catch (const std::exception& error) {
        Q_EMIT failed(coreWords(error.what()));
    }
}

MadeMotion HitSession::madeMotion() const {
    return {keys_.motions(), std::make_shared<const Clip>(motion_->clip), QStringLiteral("hit")};
}

void HitSession::setPlaying(bool playing) {
    if (playing == isPlaying() || (playing && !motion_)) return;
    if (playing) {
        seconds_ = 0;
        clock_.start();
        timer_.start();
    } else {
        timer_.stop();
        if (motion_) seconds_ = motion_->hit / motion_->clip.rate;
    }
    Q_EMIT changed();
    show();
}

void HitSession::seek(double seconds) {
    if (!motion_) return;
    setPlaying(false);
    seconds_ = std::clamp(seconds, 0.0, motion_->clip.seconds());
    show();
}

void HitSession::advance() {
    seconds_ += 1e-3 * static_cast<double>(clock_.restart());
    if (!motion_ || seconds_ > motion_->clip.seconds()) seconds_ = 0;
    show();
}

void HitSession::show() {
    shown_.reset();
    if (on_ && motion_) shown_ = poseAt(motion_->clip, std::min(seconds_, motion_->clip.seconds()));
    Q_EMIT moved();
}

}  // namespace kumite::studio
