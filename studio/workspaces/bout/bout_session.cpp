#include "studio/workspaces/bout/bout_session.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/project/kept_bout.h"
#include "studio/app/core_words.h"
#include "studio/workspaces/graph/graph_session.h"

namespace kumite::studio {

namespace {

constexpr int kTick = 15;             // ms
constexpr double kMostAtOnce = 0.25;  // seconds of bout: what a hiccup may cost at most

/// Learns, and makes a library for what is wanted. Kept is what `last` has of the same document.
BoutSource prepared(const Project& project, const Analysis& analysis, BoutSettings settings,
                    const BoutSource* last, const Progress& progress) {
    BoutSource source;
    source.project = project;
    source.interaction = deriveInteraction(
        project, analysis, {}, last ? last->interaction : Interaction{}, progress.part(0, 0.4));
    if (const auto why = whyNoModel(project, source.interaction)) {
        // The window offers its own steps.
        static const QRegularExpression commands(QStringLiteral(" \\(kumite [^)]*\\)"));
        source.whyNothing = coreWords(QString::fromStdString(*why).remove(commands).toStdString());
        return source;
    }
    const Interaction* from = &source.interaction;
    Interaction without;
    settings.attack.clear();
    if (settings.mode == BoutMode::Passive) {
        const CapturedAttack attack = busiestAttack(source.interaction, settings.attacker);
        settings.attack = attack.actions;
        without = interactionWithout(analysis, source.interaction, attack, progress.part(0.4, 0.6));
        from = &without;
    }
    source.library = boutLibrary(project, analysis, *from, progress.part(0.6, 0.8));
    if (settings.mode == BoutMode::Avatar)
        source.library = withAvatar(source.library, settings.avatar, progress.part(0.8, 1));
    for (const int player : {0, 1}) {
        source.like[std::size_t(player)] =
            fighterLike(project, *source.library->fighter(player).rig, player);
    }
    source.settings = settings;
    return source;
}

/// Whether a bout of other settings can be made of what is prepared: only what learns or leaves
/// something out needs more.
bool serves(const BoutSource& source, const BoutSettings& wanted) {
    const BoutSettings& has = source.settings;
    return source.library && has.mode == wanted.mode &&
           (wanted.mode != BoutMode::Avatar || has.avatar == wanted.avatar) &&
           (wanted.mode != BoutMode::Passive || has.attacker == wanted.attacker);
}

}  // namespace

BoutSession::BoutSession(Session& session, QObject* parent) : QObject(parent), session_(session) {
    due_.setSingleShot(true);
    due_.setInterval(0);
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(kTick);
    connect(&due_, &QTimer::timeout, this, &BoutSession::prepare);
    connect(&timer_, &QTimer::timeout, this, &BoutSession::advance);
    const auto changed = [this] {
        outdated_ = !isOf(session_.document().project());
        if (active_ && (anew_ || !tape_)) due_.start();
        Q_EMIT stateChanged();
    };
    connect(&session_.document(), &Document::changed, this, changed);
    connect(&session_.document(), &Document::analysisChanged, this, changed);
    connect(&session_.document(), &Document::opened, this, [this] {
        setPlaying(false);
        jobs_.cancel();
        judging_.cancel();
        source_.reset();
        tape_.reset();
        judgement_.reset();
        recording_.reset();
        pointed_.reset();
        words_.clear();
        outdated_ = true;
        Q_EMIT begun();
        shown();
    });
    connect(&session_, &Session::activePlayerChanged, this, [this] {
        pointed_.reset();
        shown();
    });
    connect(&jobs_, &JobRunner::failed, this, &BoutSession::failed);
    connect(&judging_, &JobRunner::failed, this, &BoutSession::failed);
    connect(&writing_, &JobRunner::failed, this, &BoutSession::failed);
    connect(&jobs_, &JobRunner::finished, this, &BoutSession::stateChanged);
    connect(&judging_, &JobRunner::finished, this, &BoutSession::stateChanged);
    connect(&writing_, &JobRunner::started, this, &BoutSession::stateChanged);
    connect(&writing_, &JobRunner::finished, this, &BoutSession::stateChanged);
}

void BoutSession::setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    if (!active_) {
        setPlaying(false);
    } else if (anew_ || !tape_) {
        due_.start();
    }
    Q_EMIT stateChanged();
}

QString BoutSession::whyNothing() const {
    return tape_ || source_ == nullptr ? QString() : source_->whyNothing;
}

double BoutSession::rate() const {
    return tape_ ? library().rate : 60.0;
}

QString BoutSession::nameOf(int player, int node) const {
    if (node == kAnyNode) return tr("anything");
    const CoupledGraph& graph = *library().graph;
    return shortLabelWords(*graph.vocabulary, graph.node(player, node).label);
}

void BoutSession::setWanted(const BoutSettings& settings) {
    if (settings == wanted_) return;
    wanted_ = settings;
    Q_EMIT stateChanged();
    begin();
}

void BoutSession::begin() {
    setPlaying(false);
    anew_ = true;
    if (active_) due_.start();
}

/// Whether what is prepared was learnt from that project.
bool BoutSession::isOf(const Project& project) const {
    return source_ && source_->project == project;
}

void BoutSession::stayWith(const Project& project) {
    if (!source_) return;
    auto source = std::make_shared<BoutSource>(*source_);
    source->project = project;
    source_ = std::move(source);
    outdated_ = false;
    Q_EMIT stateChanged();
}

void BoutSession::prepare() {
    const Document& document = session_.document();
    if (!active_ || !document.isOpen() || !document.isCurrent()) return;
    anew_ = false;
    if (isOf(document.project()) && serves(*source_, wanted_)) {
        jobs_.cancel();
        BoutSource source = *source_;
        source.settings = wanted_;
        source.settings.attack = source_->settings.attack;
        take(std::move(source));
        return;
    }
    outdated_ = false;
    jobs_.start(
        tr("Preparing a bout"),
        [project = document.project(), analysis = document.analysis(), settings = wanted_,
         last = source_](const Progress& progress) {
            return prepared(project, analysis, settings, last.get(), progress);
        },
        [this](BoutSource source) { take(std::move(source)); });
    Q_EMIT stateChanged();
}

void BoutSession::take(BoutSource source) {
    setPlaying(false);
    source_ = std::make_shared<const BoutSource>(std::move(source));
    outdated_ = !isOf(session_.document().project());
    tape_.reset();
    pointed_.reset();
    judgement_.reset();
    recording_.reset();
    judging_.cancel();
    if (source_->library) {
        attempt([this] { tape_.emplace(source_->library, source_->settings); });
    }
    gatherWords();
    Q_EMIT begun();
    shown();
}

bool BoutSession::attempt(const std::function<void()>& act) {
    try {
        act();
        return true;
    } catch (const std::exception& error) {
        setPlaying(false);
        Q_EMIT failed(coreWords(error.what()));
        return false;
    }
}

bool BoutSession::change(const std::function<void()>& act) {
    const bool done = attempt(act);
    pointed_.reset();
    judging_.cancel();
    judgement_.reset();
    shown();
    Q_EMIT judged();
    Q_EMIT stateChanged();
    return done;
}

void BoutSession::setPlaying(bool playing) {
    if (playing == isPlaying() || (playing && !tape_)) return;
    if (playing) {
        owed_ = 0;
        clock_.start();
        timer_.start();
        pointed_.reset();
    } else {
        timer_.stop();
    }
    Q_EMIT stateChanged();
}

void BoutSession::setSpeed(double speed) {
    speed_ = std::clamp(speed, 0.1, 4.0);
    Q_EMIT stateChanged();
}

void BoutSession::advance() {
    if (!tape_) return;
    const double seconds = std::min(1e-3 * static_cast<double>(clock_.restart()), kMostAtOnce);
    owed_ += seconds * rate() * speed_;
    const int frames = static_cast<int>(owed_);
    if (frames == 0) return;
    owed_ -= frames;
    attempt([this, frames] { tape_->advance(frames); });
    shown();
}

void BoutSession::seek(int frame) {
    if (!tape_) return;
    attempt([this, frame] { tape_->seek(std::clamp(frame, 0, tape_->end())); });
    pointed_.reset();
    shown();
}

void BoutSession::step(int frames) {
    if (!tape_) return;
    setPlaying(false);
    const int wished = tape_->frame() + frames;
    // One on from the last frame shows a new one.
    if (wished > tape_->end()) {
        attempt([this, wished] { tape_->advance(wished - tape_->frame()); });
        pointed_.reset();
        shown();
    } else {
        seek(wished);
    }
}

void BoutSession::shown() {
    Q_EMIT moved();
    const auto now = choice();
    const std::size_t count = tape_ ? tape_->choices().size() : 0;
    if (now == told_ && count == choices_) return;
    told_ = now;
    choices_ = count;
    Q_EMIT choicesChanged();
}

std::shared_ptr<const BoutChoice> BoutSession::choice() const {
    if (pointed_ || !tape_) return pointed_;
    const auto& all = tape_->choices();
    for (auto each = all.rbegin(); each != all.rend(); ++each) {
        if ((*each)->frame <= tape_->frame() && (*each)->player == player()) return *each;
    }
    return nullptr;
}

void BoutSession::pointTo(std::shared_ptr<const BoutChoice> choice) {
    if (!choice || !tape_) return;
    setPlaying(false);
    const int frame = choice->frame;
    session_.setActivePlayer(choice->player);
    attempt([this, frame] { tape_->seek(std::min(frame, tape_->end())); });
    pointed_ = std::move(choice);
    shown();
}

void BoutSession::chooseInstead(const BoutChoice& choice, int node) {
    if (!tape_) return;
    if (change([&] { tape_->chooseInstead(choice, node); })) setPlaying(true);
}

void BoutSession::reseed(std::uint64_t seed) {
    if (!tape_) return;
    BoutCommand command;
    command.kind = BoutCommand::Kind::Seed;
    command.seed = seed;
    if (change([&] { tape_->command(command); })) setPlaying(true);
}

/// Groups of strikes, then aspects: of each what the avatar really shows.
void BoutSession::gatherWords() {
    words_.clear();
    if (!tape_) return;
    const int avatar = tape_->now().settings().avatar;
    const auto add = [&](const std::string& word) {
        const bool known = std::find(words_.begin(), words_.end(), word) != words_.end();
        if (known || word.empty()) return;
        try {
            if (!commandedNodes(library(), avatar, word).empty()) words_.push_back(word);
        } catch (const std::exception&) {
            // This fighter never shows it: no key for it.
        }
    };
    for (const Aspect& aspect : library().vocabulary().aspects)
        add(aspect.strike);
    for (const Aspect& aspect : library().vocabulary().aspects) {
        if (aspect.classifier == Classifier::Msvm) add(aspect.id);
    }
}

void BoutSession::ask(const std::string& words) {
    if (!steers()) return;
    BoutCommand command;
    command.kind = BoutCommand::Kind::Act;
    command.player = tape_->now().settings().avatar;
    command.words = words;
    change([&] { tape_->command(command); });
}

void BoutSession::release() {
    // A bout in which nothing is asked for goes on as it is.
    if (!steers() || tape_->now().wish().empty()) return;
    BoutCommand command;
    command.kind = BoutCommand::Kind::Release;
    change([&] { tape_->command(command); });
}

void BoutSession::setTarget(const std::optional<Eigen::Vector2d>& target) {
    if (!steers() || target == tape_->now().target()) return;
    BoutCommand command;
    command.kind = target ? BoutCommand::Kind::Target : BoutCommand::Kind::NoTarget;
    if (target) command.target = *target;
    change([&] { tape_->command(command); });
}

void BoutSession::judge() {
    if (!tape_ || tape_->end() == 0) return;
    struct Judged {
        BoutJudgement judgement;
        std::shared_ptr<const RecordingQuality> recording;
    };
    judging_.start(
        tr("Measuring the bout"),
        [tape = *tape_, known = recording_, rate = rate()](const Progress& progress) {
            Judged result;
            result.recording = known ? known
                                     : std::make_shared<const RecordingQuality>(recordingQuality(
                                           tape.now().library(), progress.part(0, 0.5)));
            result.judgement.recording = result.recording->quality;
            result.judgement.bout = boutQuality(tape, result.recording->bar, progress.part(0.5, 1));
            result.judgement.seconds = tape.end() / rate;
            return result;
        },
        [this](Judged result) {
            recording_ = result.recording;
            judgement_ = result.judgement;
            Q_EMIT judged();
        });
    Q_EMIT stateChanged();
}

}  // namespace kumite::studio
