#include "studio/workspaces/keyframe/key_session.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/motion/blend.h"
#include "core/project/library.h"
#include "core/project/placed_clip.h"
#include "studio/app/core_words.h"
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
        source.whyNothing = coreWords(error.what());
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
    // Of another project the draft waits for its library, which may name its motions otherwise.
    if (library() != nullptr && isOfProject()) readDraft();
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
        problem_ = coreWords(error.what());
    }
    dragged_.reset();
    if (key_ && !draft_.track.find(*key_)) key_.reset();
    if (joint_ && *joint_ >= draft_.track.rig->jointCount()) joint_.reset();
    Q_EMIT draftChanged();
    Q_EMIT chosen();
    make();
    show();
}

bool KeySession::isOfProject() const {
    return source_ && source_->made == withoutDrafts(session_.document().project());
}

void KeySession::prepare() {
    const Document& document = session_.document();
    if (!active_ || !document.isOpen() || !document.isCurrent()) return;
    if (isOfProject()) {
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
                for (const BodyPart part : allParts()) {
                    progress.update(0.8 + 0.03 * static_cast<double>(part));
                    motion->foundOfPart[static_cast<std::size_t>(part)] =
                        findSimilar(*library, draft.track, part, settings);
                }
                motion->assembly = assemble(*library, draft.track, motion->plan, draft.assembly);
                AssemblySettings plain = draft.assembly;
                plain.adjusted = false;
                plain.meetKeys = 0;
                motion->direct = assemble(*library, draft.track, motion->plan, plain);
                made.motion = std::move(motion);
            } catch (const Cancelled&) {
                throw;
            } catch (const std::exception& error) {
                made.problem = coreWords(error.what());
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

void KeySession::choose(std::optional<int> frame) {
    if (frame && !draft_.track.find(*frame)) frame.reset();
    key_ = frame;
    dragged_.reset();
    session_.document().endGesture();
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

void KeySession::setShowsMotion(bool motion) {
    motion = motion && motion_ != nullptr;
    if (motion == showsMotion_) return;
    showsMotion_ = motion;
    dragged_.reset();
    frame_ = std::clamp(frame_, double(firstFrame()), double(lastFrame()));
    show();
    Q_EMIT stateChanged();
}

void KeySession::setShowsNeighbours(bool on) {
    showsNeighbours_ = on;
    show();
    Q_EMIT stateChanged();
}

std::vector<Pose> KeySession::neighbours() const {
    const KeyPose *before = nullptr, *after = nullptr;
    for (const KeyPose& key : draft_.track.keys) {
        if (key.frame < frame_ - 1e-6) before = &key;
        if (key.frame > frame_ + 1e-6 && after == nullptr) after = &key;
    }
    std::vector<Pose> poses;
    if (before != nullptr) poses.push_back(before->pose);
    if (after != nullptr) poses.push_back(after->pose);
    return poses;
}

void KeySession::setShowsDirect(bool on) {
    showsDirect_ = on;
    if (on) setShowsMotion(true);
    show();
    Q_EMIT stateChanged();
}

std::optional<Pose> KeySession::directPose() const {
    if (!showsDirect_ || !showsMotion_ || motion_ == nullptr) return std::nullopt;
    const Clip& clip = motion_->direct.clip;
    return poseAt(clip, std::clamp((frame_ - firstFrame()) / rate(), 0.0, clip.seconds()));
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
