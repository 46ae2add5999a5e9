#include "studio/workspaces/sequence/sequence_session.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/motion/blend.h"
#include "core/transition/cluster_places.h"
#include "studio/app/core_words.h"
#include "studio/workspaces/graph/graph_session.h"

namespace kumite::studio {

namespace {

constexpr int kTick = 16;             // milliseconds
constexpr double kMostAtOnce = 0.25;  // seconds that a busy window may lag behind

Project withoutDrafts(Project project) {
    project.drafts.clear();
    return project;
}

SequenceSource prepared(const Project& project, const Analysis& analysis,
                        const Progress& progress) {
    SequenceSource source;
    source.made = withoutDrafts(project);
    try {
        LoadedLibrary loaded = libraryOf(project, analysis, {}, progress.part(0, 0.5));
        source.findings = std::move(loaded.findings);
        source.library = std::make_shared<const MotionLibrary>(std::move(loaded.library));
        source.graph = buildFlexibleGraph(source.library, {}, progress.part(0.5, 0.9));
        source.places = clusterPlaces(source.graph->clusters, 1500, progress.part(0.9, 1));
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        source.library = nullptr;
        source.graph = nullptr;
        source.whyNothing = coreWords(error.what());
    }
    return source;
}

}  // namespace

SequenceSession::SequenceSession(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
    due_.setSingleShot(true);
    due_.setInterval(0);
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kTick);
    connect(&due_, &QTimer::timeout, this, &SequenceSession::prepare);
    connect(&timer_, &QTimer::timeout, this, &SequenceSession::advance);
    connect(&session_.document(), &Document::changed, this, &SequenceSession::follow);
    connect(&session_.document(), &Document::analysisChanged, this, [this] {
        if (active_) due_.start();
    });
    connect(&session_.document(), &Document::opened, this, [this] {
        setPlaying(false);
        jobs_.cancel();
        making_.cancel();
        live_.reset();
        source_.reset();
        motion_.reset();
        selected_.reset();
        seconds_ = 0;
        showing_ = Showing::Sequence;
        Q_EMIT libraryChanged();
        follow();
        show();
    });
    for (JobRunner* runner : {&jobs_, &making_, &writing_}) {
        connect(runner, &JobRunner::failed, this, &SequenceSession::failed);
        connect(runner, &JobRunner::started, this, &SequenceSession::stateChanged);
        connect(runner, &JobRunner::finished, this, &SequenceSession::stateChanged);
    }
}

void SequenceSession::setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    if (active_) {
        due_.start();
    } else {
        setPlaying(false);
    }
    Q_EMIT stateChanged();
}

const MotionLibrary* SequenceSession::library() const {
    return source_ ? source_->library.get() : nullptr;
}

std::shared_ptr<const MotionLibrary> SequenceSession::sharedLibrary() const {
    return source_ ? source_->library : nullptr;
}

MadeMotion SequenceSession::madeMotion() const {
    return {sharedLibrary(), {motion_, &motion_->clip}, QStringLiteral("sequence")};
}

const Findings& SequenceSession::findings() const {
    static const Findings none;
    return source_ ? source_->findings : none;
}

QString SequenceSession::whyNothing() const {
    return source_ ? source_->whyNothing : QString();
}

QString SequenceSession::titleOf(const LibraryAction& action) const {
    if (action.label.empty()) return QString::fromStdString(action.name);
    const Vocabulary& vocabulary = *session_.document().project().labelling.vocabulary;
    try {
        return shortLabelWords(vocabulary, parseLabel(vocabulary, action.label));
    } catch (const std::exception&) {
        // A clip of another project may be labelled by another vocabulary.
        return QString::fromStdString(action.label);
    }
}

QString SequenceSession::titleOf(const DraftBlock& block) const {
    return QString::fromStdString(block.title.empty() ? block.clip : block.title);
}

void SequenceSession::follow() {
    SequenceDraft draft;
    if (session_.document().isOpen()) {
        try {
            draft = sequenceDraftOf(session_.document().project());
        } catch (const std::exception& error) {
            Q_EMIT failed(coreWords(error.what()));
        }
    }
    if (draft != draft_) {
        draft_ = std::move(draft);
        const int count = static_cast<int>(draft_.blocks.size());
        if (selected_ && selected_->block >= count) {
            selected_.reset();
            Q_EMIT selectionChanged();
        }
        Q_EMIT draftChanged();
        make();
    }
    if (active_) due_.start();
}

void SequenceSession::prepare() {
    const Document& document = session_.document();
    if (!active_ || !document.isOpen() || !document.isCurrent()) return;
    if (source_ && source_->made == withoutDrafts(document.project())) {
        if (!isCurrent()) make();
        return;
    }
    jobs_.start(
        tr("Preparing the clips"),
        [project = document.project(), analysis = document.analysis()](const Progress& progress) {
            return prepared(project, analysis, progress);
        },
        [this](SequenceSource source) {
            setLive(false);
            preview({});
            source_ = std::make_shared<const SequenceSource>(std::move(source));
            shownDraft_ = {};
            motion_.reset();
            Q_EMIT libraryChanged();
            make();
        });
}

void SequenceSession::make() {
    problem_.clear();
    if (!active_ || library() == nullptr) return;
    if (draft_.blocks.empty()) {
        making_.cancel();
        motion_.reset();
        shownDraft_ = draft_;
        Q_EMIT motionChanged();
        show();
        return;
    }
    struct Made {
        SequenceDraft draft;
        std::shared_ptr<const SequenceMotion> motion;
        QString problem;
    };
    making_.start(
        tr("Making the motion"),
        [draft = draft_, source = source_](const Progress& progress) {
            Made made;
            made.draft = draft;
            try {
                made.motion = std::make_shared<const SequenceMotion>(
                    makeSequence(source->graph, sequenceOf(*source->library, draft), progress));
            } catch (const Cancelled&) {
                throw;
            } catch (const std::exception& error) {
                made.problem = coreWords(error.what());
            }
            return made;
        },
        [this](Made made) {
            problem_ = made.problem;
            if (made.motion) motion_ = std::move(made.motion);
            if (problem_.isEmpty()) shownDraft_ = std::move(made.draft);
            if (showing_ == Showing::Sequence) seconds_ = std::clamp(seconds_, 0.0, length());
            Q_EMIT motionChanged();
            show();
        });
}

void SequenceSession::apply(SequenceDraft draft, const QString& edit) {
    session_.document().apply(Document::ProjectEdit([&](const Project& project) {
        return setSequenceDraft(project, draft, edit.toStdString());
    }));
}

void SequenceSession::insert(const LibraryAction& action, std::optional<int> at) {
    if (library() == nullptr) return;
    SequenceDraft draft = draft_;
    DraftBlock block;
    block.clip = lastingName(*library(), action);
    block.title = titleOf(action).toStdString();
    block.transition.seed = 1 + draft.blocks.size();
    const int count = static_cast<int>(draft.blocks.size());
    const int place = std::clamp(at.value_or(count), 0, count);
    draft.blocks.insert(draft.blocks.begin() + place, block);
    preview({});
    apply(std::move(draft), tr("Add %1").arg(titleOf(block)));
    select(SequencePart{place, false});
}

void SequenceSession::replace(int block, const LibraryAction& action) {
    if (library() == nullptr) return;
    const std::string clip = lastingName(*library(), action);
    const std::string title = titleOf(action).toStdString();
    change(block, tr("Swap for %1").arg(QString::fromStdString(title)), [&](DraftBlock& each) {
        each.clip = clip;
        each.title = title;
        each.trim.reset();
    });
    preview({});
}

void SequenceSession::remove(int block) {
    SequenceDraft draft = draft_;
    if (block < 0 || block >= static_cast<int>(draft.blocks.size())) return;
    const QString name = titleOf(draft.blocks[static_cast<std::size_t>(block)]);
    draft.blocks.erase(draft.blocks.begin() + block);
    const int left = static_cast<int>(draft.blocks.size());
    apply(std::move(draft), tr("Remove %1").arg(name));
    select(left > 0 ? std::optional(SequencePart{std::min(block, left - 1), false}) : std::nullopt);
}

void SequenceSession::move(int block, int to) {
    SequenceDraft draft = draft_;
    const int count = static_cast<int>(draft.blocks.size());
    to = std::clamp(to, 0, count - 1);
    if (block < 0 || block >= count || block == to) return;
    const auto begin = draft.blocks.begin();
    if (to > block) {
        std::rotate(begin + block, begin + block + 1, begin + to + 1);
    } else {
        std::rotate(begin + to, begin + block, begin + block + 1);
    }
    const QString name = titleOf(draft.blocks[static_cast<std::size_t>(to)]);
    apply(std::move(draft), tr("Move %1").arg(name));
    select(SequencePart{to, false});
}

void SequenceSession::clear() {
    apply({}, tr("Clear the sequence"));
    select({});
}

void SequenceSession::change(int block, const QString& edit,
                             const std::function<void(DraftBlock&)>& act) {
    SequenceDraft draft = draft_;
    if (block < 0 || block >= static_cast<int>(draft.blocks.size())) return;
    act(draft.blocks[static_cast<std::size_t>(block)]);
    apply(std::move(draft), edit);
}

void SequenceSession::drawAnew(std::optional<int> block) {
    SequenceDraft draft = draft_;
    for (std::size_t i = 0; i < draft.blocks.size(); ++i) {
        if (block ? static_cast<int>(i) != *block : draft.blocks[i].locked) continue;
        draft.blocks[i].transition.seed += 1000003;
        draft.blocks[i].transition.path.reset();
        if (draft.blocks[i].transition.seed > 2000000000) draft.blocks[i].transition.seed = 1 + i;
    }
    apply(std::move(draft), block ? tr("Draw the transition anew") : tr("Draw all anew"));
}

void SequenceSession::select(std::optional<SequencePart> part) {
    if (part && (part->block < 0 || part->block >= static_cast<int>(draft_.blocks.size())))
        part.reset();
    if (part == selected_) return;
    selected_ = part;
    Q_EMIT selectionChanged();
}

std::optional<int> SequenceSession::selectedBlock() const {
    return selected_ ? std::optional(selected_->block) : std::nullopt;
}

const SequencePiece* SequenceSession::selectedPiece() const {
    if (!selected_ || !isCurrent()) return nullptr;
    for (const SequencePiece& piece : motion_->pieces) {
        if (piece.block == selected_->block &&
            piece.transition.has_value() == selected_->transition)
            return &piece;
    }
    return nullptr;
}

void SequenceSession::preview(const std::optional<LibraryAction>& action) {
    if (!action || library() == nullptr) {
        if (showing_ != Showing::Action) return;
        showing_ = Showing::Sequence;
        setPlaying(false);
        seconds_ = 0;
    } else {
        setLive(false);
        const MotionPart part = library()->part(*action);
        preview_ = {library()->rig, library()->rate, {part.poses.begin(), part.poses.end()}};
        showing_ = Showing::Action;
        seconds_ = 0;
        setPlaying(true);
    }
    show();
    Q_EMIT stateChanged();
}

void SequenceSession::setLive(bool live) {
    if (live == (showing_ == Showing::Live) || (live && library() == nullptr)) return;
    setPlaying(false);
    liveReport_.reset();
    if (live) {
        live_ = std::make_unique<PlaybackBuffer>(source_->graph);
        showing_ = Showing::Live;
        shown_.reset();
        playLive(0);
    } else {
        live_.reset();
        showing_ = Showing::Sequence;
        seconds_ = std::clamp(seconds_, 0.0, length());
        show();
    }
    Q_EMIT stateChanged();
}

void SequenceSession::playLive(int block) {
    if (!live_ || block < 0 || block >= static_cast<int>(draft_.blocks.size())) return;
    try {
        const SequenceBlock wanted =
            blockNamed(*library(), draft_.blocks[static_cast<std::size_t>(block)].clip);
        const MotionPart part = wanted.made
                                    ? MotionPart{wanted.made->clip.frames, wanted.made->standing}
                                    : library()->part(wanted.action);
        const bool first = live_->empty();
        TransitionReport report = live_->play(part);
        if (!first) liveReport_ = std::move(report);
        select(SequencePart{block, false});
        setPlaying(true);
        Q_EMIT stateChanged();
    } catch (const std::exception& error) {
        Q_EMIT failed(coreWords(error.what()));
    }
}

const Clip* SequenceSession::clip() const {
    if (showing_ == Showing::Action) return &preview_;
    return showing_ == Showing::Sequence && motion_ ? &motion_->clip : nullptr;
}

double SequenceSession::length() const {
    return clip() != nullptr ? clip()->seconds() : 0;
}

void SequenceSession::seek(double seconds) {
    if (showing_ == Showing::Live) return;
    seconds_ = std::clamp(seconds, 0.0, length());
    show();
}

void SequenceSession::step(int frames) {
    setPlaying(false);
    if (clip() == nullptr) return;
    seek((std::round(seconds_ * clip()->rate) + frames) / clip()->rate);
}

void SequenceSession::setPlaying(bool playing) {
    if (playing == isPlaying()) return;
    if (playing && showing_ != Showing::Live && clip() == nullptr) return;
    if (playing) {
        if (showing_ == Showing::Sequence && seconds_ >= length() - 1e-6) seconds_ = 0;
        owed_ = 0;
        clock_.start();
        timer_.start();
    } else {
        timer_.stop();
    }
    Q_EMIT stateChanged();
}

void SequenceSession::advance() {
    const double passed = std::min(1e-3 * static_cast<double>(clock_.restart()), kMostAtOnce);
    if (showing_ == Showing::Live) {
        owed_ += passed * library()->rate;
        for (; owed_ >= 1; owed_ -= 1)
            shown_ = live_->next();
        Q_EMIT moved();
        return;
    }
    seconds_ += passed;
    if (seconds_ > length()) {
        if (showing_ == Showing::Action || looping_) {
            seconds_ = 0;
        } else {
            seconds_ = length();
            setPlaying(false);
        }
    }
    show();
}

void SequenceSession::show() {
    if (showing_ != Showing::Live) {
        if (const Clip* now = clip(); now != nullptr && now->frameCount() > 0) {
            shown_ = poseAt(*now, seconds_);
        } else {
            shown_.reset();
        }
    }
    Q_EMIT moved();
}

}  // namespace kumite::studio
