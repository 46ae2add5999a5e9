#include "studio/workspaces/keyframe/key_session.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/motion/blend.h"
#include "core/project/library.h"
#include "core/project/placed_clip.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

constexpr double kRate = 60;          // Hz of library and keys
constexpr int kTick = 16;             // milliseconds
constexpr double kMostAtOnce = 0.25;  // seconds that a busy window may lag behind
constexpr int kFound = 12;

Project withoutDrafts(Project project) {
    project.drafts.clear();
    return project;
}

KeySource prepared(const Project& project, const Analysis& analysis, const Progress& progress) {
    KeySource source;
    source.made = withoutDrafts(project);
    try {
        LoadedLibrary loaded = libraryOf(project, analysis, {kRate}, progress.part(0, 0.6));
        source.library = std::make_shared<const KeyLibrary>(
            keyLibrary(std::make_shared<const MotionLibrary>(std::move(loaded.library)), {},
                       progress.part(0.6, 1)));
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        source.whyNothing = QString::fromUtf8(error.what());
    }
    return source;
}

}  // namespace

KeySession::KeySession(Session& session, QObject* parent) : QObject(parent), session_(session) {
    due_.setSingleShot(true);
    due_.setInterval(0);
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kTick);
    connect(&due_, &QTimer::timeout, this, &KeySession::prepare);
    connect(&timer_, &QTimer::timeout, this, &KeySession::advance);
    connect(&session_.document(), &Document::changed, this, &KeySession::follow);
    connect(&session_.document(), &Document::analysisChanged, this, [this] {
        if (active_) due_.start();
    });
    connect(&session_.document(), &Document::opened, this, [this] {
        setPlaying(false);
        jobs_.cancel();
        making_.cancel();
        source_.reset();
        motion_.reset();
        draft_ = {};
        draftText_.clear();
        key_.reset();
        dragged_.reset();
        frame_ = 0;
        showsMotion_ = false;
        Q_EMIT libraryChanged();
        if (active_) due_.start();
        show();
    });
    for (JobRunner* runner : {&jobs_, &making_, &writing_}) {
        connect(runner, &JobRunner::failed, this, &KeySession::failed);
        connect(runner, &JobRunner::started, this, &KeySession::stateChanged);
        connect(runner, &JobRunner::finished, this, &KeySession::stateChanged);
    }
}

void KeySession::setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    if (active_) {
        due_.start();
    } else {
        setPlaying(false);
    }
    Q_EMIT stateChanged();
}

std::shared_ptr<const MotionLibrary> KeySession::motions() const {
    return library() != nullptr ? library()->library : nullptr;
}

QString KeySession::placeOf(const PoseMatch& match) const {
    const LibraryMotion& motion = library()->motion(match.match.clip);
    return tr("%1 %2 to %3")
        .arg(QString::fromStdString(motion.name),
             timeText(match.match.frames.front() / library()->features.rate, 0.1),
             timeText(match.match.frames.back() / library()->features.rate, 0.1));
}

MadeMotion KeySession::madeMotion() const {
    return {motions(), {motion_, &motion_->assembly.clip}, QStringLiteral("keyframes")};
}

void KeySession::follow() {
    if (!active_) return;
    if (library() != nullptr) readDraft();
    due_.start();
}

void KeySession::readDraft() {
    const auto& drafts = session_.document().project().drafts;
    const auto found = drafts.find("keys");
    const std::string text = found == drafts.end() ? std::string() : found->second;
    if (text == draftText_ && draft_.track.rig == motions()->rig) return;
    draftText_ = text;
    problem_.clear();
    try {
        draft_ = keyDraftOf(session_.document().project(), motions()->rig, kRate);
    } catch (const std::exception& error) {
        draft_ = {};
        draft_.track.rig = motions()->rig;
        draft_.track.rate = kRate;
        problem_ = QString::fromUtf8(error.what());
    }
    dragged_.reset();
    if (key_ && !draft_.track.find(*key_)) key_.reset();
    Q_EMIT draftChanged();
    Q_EMIT chosen();
    make();
    show();
}

void KeySession::prepare() {
    const Document& document = session_.document();
    if (!active_ || !document.isOpen() || !document.isCurrent()) return;
    if (source_ && source_->made == withoutDrafts(document.project())) {
        if (library() != nullptr) readDraft();
        return;
    }
    jobs_.start(
        tr("Preparing the clips"),
        [project = document.project(), analysis = document.analysis()](const Progress& progress) {
            return prepared(project, analysis, progress);
        },
        [this](KeySource source) {
            source_ = std::make_shared<const KeySource>(std::move(source));
            motion_.reset();
            Q_EMIT libraryChanged();
            if (library() != nullptr) readDraft();
            make();
        });
}

void KeySession::make() {
    current_ = false;
    if (!active_ || library() == nullptr) return;
    if (draft_.track.keys.size() < 2) {
        making_.cancel();
        motion_.reset();
        if (showsMotion_) setShowsMotion(false);
        Q_EMIT motionChanged();
        return;
    }
    struct Made {
        std::shared_ptr<const KeyMotion> motion;
        QString problem;
    };
    making_.start(
        tr("Making the motion"),
        [draft = draft_, library = source_->library](const Progress& progress) {
            Made made;
            try {
                auto motion = std::make_shared<KeyMotion>();
                RetrievalSettings settings;
                settings.results = kFound;
                motion->found =
                    findSimilar(*library, draft.track, {}, settings, progress.part(0, 0.4));
                motion->plan =
                    planAssembly(*library, draft.track, choicesOf(*library->library, draft),
                                 progress.part(0.4, 0.8));
                motion->assembly = assemble(*library, draft.track, motion->plan, draft.assembly);
                made.motion = std::move(motion);
            } catch (const Cancelled&) {
                throw;
            } catch (const std::exception& error) {
                made.problem = QString::fromUtf8(error.what());
            }
            return made;
        },
        [this](Made made) {
            problem_ = made.problem;
            motion_ = std::move(made.motion);
            current_ = motion_ != nullptr;
            if (motion_ == nullptr) showsMotion_ = false;
            Q_EMIT motionChanged();
            show();
        });
}

bool KeySession::attempt(const std::function<void()>& act) {
    try {
        act();
        return true;
    } catch (const std::exception& error) {
        Q_EMIT failed(QString::fromUtf8(error.what()));
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
    if (fighter == nullptr || motions() == nullptr) return std::nullopt;
    const std::string name =
        session_.document().project().takes[static_cast<std::size_t>(session_.take())].name + ":" +
        std::to_string(session_.activePlayer() + 1);
    for (const LibraryMotion& motion : motions()->motions) {
        if (motion.name != name) continue;
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
    const auto recorded = poseOfTake();
    if (!key_ || !recorded) return;
    change(tr("Take the pose of the recording"), [&](KeyDraft& draft) {
        const std::size_t index = static_cast<std::size_t>(*draft.track.find(*key_));
        KeyPose& key = draft.track.keys[index];
        const Eigen::Vector3d place = key.pose.root;
        key.pose = *recorded;
        key.pose.root.x() = place.x();
        key.pose.root.z() = place.z();
    });
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

void KeySession::choose(std::optional<int> frame) {
    if (frame && !draft_.track.find(*frame)) frame.reset();
    key_ = frame;
    dragged_.reset();
    if (frame) {
        setPlaying(false);
        frame_ = *frame;
        showsMotion_ = false;
    }
    Q_EMIT chosen();
    show();
}

void KeySession::chooseNext(int direction) {
    const auto& keys = draft_.track.keys;
    if (keys.empty()) return;
    const double now = key_ ? *key_ : frame_;
    if (direction > 0) {
        for (const KeyPose& key : keys) {
            if (key.frame > now) return choose(key.frame);
        }
    } else {
        for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
            if (key->frame < now) return choose(key->frame);
        }
    }
    if (!key_) choose(direction > 0 ? keys.back().frame : keys.front().frame);
}

void KeySession::setHandle(Handle handle) {
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
    show();
}

void KeySession::release() {
    if (!dragged_ || !key_) return;
    const Pose pose = *dragged_;
    const QString name =
        QString::fromLatin1(handleName(handle_).data(), qsizetype(handleName(handle_).size()))
            .replace(QLatin1Char('_'), QLatin1Char(' '));
    missing_ = 0;
    change(tr("Drag the %1").arg(name), [&](KeyDraft& draft) {
        draft.track.keys[static_cast<std::size_t>(*draft.track.find(*key_))].pose = pose;
    });
    dragged_.reset();
    show();
}

void KeySession::place(Handle handle, const Eigen::Vector3d& place) {
    drag(handle, place);
    handle_ = handle;
    release();
}

void KeySession::setShowsMotion(bool motion) {
    motion = motion && motion_ != nullptr;
    if (motion == showsMotion_) return;
    showsMotion_ = motion;
    dragged_.reset();
    frame_ = std::clamp(frame_, double(firstFrame()), double(lastFrame()));
    show();
    Q_EMIT stateChanged();
}

bool KeySession::isEditable() const {
    return key_ && !showsMotion_ && !isPlaying() && std::abs(frame_ - *key_) < 1e-6 &&
           draft_.track.find(*key_).has_value();
}

int KeySession::firstFrame() const {
    return draft_.track.keys.empty() ? 0 : draft_.track.keys.front().frame;
}

int KeySession::lastFrame() const {
    return draft_.track.keys.empty() ? 0 : draft_.track.keys.back().frame;
}

void KeySession::seek(double frame) {
    frame_ = std::max(0.0, frame);
    dragged_.reset();
    const int whole = static_cast<int>(std::lround(frame_));
    const bool onKey = std::abs(frame_ - whole) < 1e-6 && draft_.track.find(whole);
    const auto key = onKey ? std::optional(whole) : std::nullopt;
    if (key != key_) {
        key_ = key;
        Q_EMIT chosen();
    }
    show();
}

void KeySession::step(int frames) {
    setPlaying(false);
    seek(std::round(frame_) + frames);
}

void KeySession::setPlaying(bool playing) {
    if (playing == isPlaying() || (playing && draft_.track.keys.size() < 2)) return;
    if (playing) {
        if (frame_ >= lastFrame() - 1e-6 || frame_ < firstFrame()) frame_ = firstFrame();
        clock_.start();
        timer_.start();
    } else {
        timer_.stop();
    }
    show();
    Q_EMIT stateChanged();
}

void KeySession::advance() {
    const double passed = std::min(1e-3 * static_cast<double>(clock_.restart()), kMostAtOnce);
    frame_ += passed * rate();
    if (frame_ > lastFrame()) frame_ = firstFrame();  // a short motion is seen again and again
    show();
}

void KeySession::show() {
    shown_.reset();
    if (dragged_) {
        shown_ = dragged_;
    } else if (showsMotion_ && motion_ != nullptr && motion_->assembly.clip.frameCount() > 0) {
        const Clip& clip = motion_->assembly.clip;
        shown_ = poseAt(clip, std::clamp((frame_ - firstFrame()) / rate(), 0.0, clip.seconds()));
    } else if (!draft_.track.keys.empty()) {
        shown_ = poseAt(draft_.track, frame_);
    }
    Q_EMIT moved();
}

}  // namespace kumite::studio
