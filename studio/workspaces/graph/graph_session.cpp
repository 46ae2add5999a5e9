#include "studio/workspaces/graph/graph_session.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

#include "studio/app/core_words.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

GraphValues learnt(const Project& project, const Analysis& analysis, const GraphOptions& options,
                   const GraphValues* last, const Progress& progress) {
    GraphValues values;
    values.analysis = analysis;
    InteractionSettings settings;
    settings.estimator = options.estimator;
    values.interaction =
        deriveInteraction(project, analysis, settings, last ? last->interaction : Interaction{},
                          progress.part(0, 0.5));
    if (const auto why = whyNoModel(project, values.interaction)) {
        // The window offers its own steps.
        static const QRegularExpression commands(QStringLiteral(" \\(kumite [^)]*\\)"));
        values.whyNothing = coreWords(QString::fromStdString(*why).remove(commands).toStdString());
    }
    const bool same = last && last->interaction.graph == values.interaction.graph;
    for (const std::size_t mover : {0U, 1U}) {
        const auto& model = values.interaction.models[mover];
        progress.update(0.5 + 0.1 * static_cast<double>(mover));
        values.surprises[mover] = same && last->interaction.models[mover] == model
                                      ? last->surprises[mover]
                                      : surprises(*model);
    }
    values.layout = same ? last->layout
                         : layOutGraph(layoutGraphOf(*values.interaction.graph),
                                       last ? &last->layout : nullptr);
    progress.update(0.8);
    if (options.versus == Versus::Estimator) {
        settings.estimator = options.versusEstimator;
        values.other = deriveInteraction(project, analysis, settings, {}, progress.part(0.8, 1));
    } else if (options.versus == Versus::HandLabels) {
        values.other = deriveInteraction(withHandLabels(project), analysis, settings, {},
                                         progress.part(0.8, 1));
    }
    return values;
}

/// Index of a player's action at a frame of a take; -1 where there is none.
int actionIndexAt(const CoupledGraph& graph, int player, int take, int frame) {
    const auto& all = graph.actions[static_cast<std::size_t>(player)];
    const auto after = std::upper_bound(all.begin(), all.end(), std::pair(take, frame),
                                        [](const auto& at, const BasicAction& action) {
                                            return at < std::pair(action.take, action.frames.begin);
                                        });
    if (after == all.begin()) return -1;
    const BasicAction& found = *(after - 1);
    const bool inside = found.take == take && frame <= found.frames.end;
    return inside ? static_cast<int>(after - all.begin()) - 1 : -1;
}

/// Nodes of the old graph as nodes of the new one; kAnyNode stays, what is gone gives nothing.
std::optional<int> carried(const CoupledGraph& from, const CoupledGraph& to, int player, int node) {
    if (node == kAnyNode) return kAnyNode;
    return to.find(player, from.node(player, node).label);
}

/// What is behind a selection; of a pair of labels that never led there, what shares one of them.
std::vector<int> behind(const CoupledGraph& graph, const GraphSelection& selection) {
    TransitionFilter filter = selection.filter;
    std::vector<int> found = transitionsBehind(graph, selection.mover, filter);
    if (!found.empty() || filter.own == kAnyNode || filter.opponent == kAnyNode) return found;
    filter.opponent = kAnyNode;
    found = transitionsBehind(graph, selection.mover, filter);
    if (!found.empty()) return found;
    filter = selection.filter;
    filter.own = kAnyNode;
    return transitionsBehind(graph, selection.mover, filter);
}

}  // namespace

std::optional<GraphSelection> carried(const GraphSelection& selection, const CoupledGraph& from,
                                      const CoupledGraph& to) {
    const int mover = selection.mover;
    const auto own = carried(from, to, mover, selection.filter.own);
    const auto opponent = carried(from, to, 1 - mover, selection.filter.opponent);
    const auto next = carried(from, to, mover, selection.filter.next);
    if (!own || !opponent || !next) return std::nullopt;
    return GraphSelection{mover, {*own, *opponent, *next}};
}

bool operator==(const GraphSelection& a, const GraphSelection& b) {
    return a.mover == b.mover && a.filter.own == b.filter.own &&
           a.filter.opponent == b.filter.opponent && a.filter.next == b.filter.next;
}

QString shortLabelWords(const Vocabulary& vocabulary, const Label& label) {
    QStringList words;
    for (int a = 0; a < vocabulary.size() && a < static_cast<int>(label.size()); ++a) {
        const Aspect& aspect = vocabulary[a];
        const int qualifier = label[static_cast<std::size_t>(a)];
        if (qualifier == kUnknown || aspect.fallback == qualifier) continue;
        const QString id = shortWords(aspect.qualifiers[static_cast<std::size_t>(qualifier)]);
        // What has no "none" is said in every label: its name would only make them long.
        if (!aspect.fallback) {
            words.append(id);
        } else {
            words.append(vocabularyInText(aspect.name) + QLatin1Char(' ') + id);
        }
    }
    return words.isEmpty() ? GraphSession::tr("others") : words.join(QStringLiteral(", "));
}

QString surpriseName(SurpriseKind kind) {
    if (kind == SurpriseKind::Label) return GraphSession::tr("label");
    return kind == SurpriseKind::Geometry ? GraphSession::tr("geometry") : GraphSession::tr("both");
}

QString surpriseWords(const Surprise& surprise) {
    const auto p = [](double nats) {
        const double value = std::exp(-nats);
        return value < 0.0005 ? GraphSession::tr("P <0.001")
                              : GraphSession::tr("P %1").arg(numberText(value, 3));
    };
    return GraphSession::tr("surprise %1 (%2 seen the motion): label %3 (%4), geometry %5")
        .arg(numberText(surprise.both, 1), p(surprise.both), numberText(surprise.label, 1),
             p(surprise.label), QString::asprintf("%+.1f", surprise.geometry));
}

Project withHandLabels(const Project& project) {
    Project result = project;
    for (Take& take : result.takes) {
        for (Fighter& fighter : take.fighters) {
            LabelTrack track;
            for (ActionLabel label : *fighter.labels) {
                for (AspectValue& value : label.aspects) {
                    if (!value.byHand()) value = {};
                }
                if (label.anyByHand()) track.push_back(std::move(label));
            }
            fighter.labels = std::move(track);
        }
    }
    return result;
}

GraphSession::GraphSession(Session& session, QObject* parent) : QObject(parent), session_(session) {
    due_.setSingleShot(true);
    due_.setInterval(0);
    connect(&due_, &QTimer::timeout, this, &GraphSession::learn);
    const auto changed = [this] {
        stale_ = true;
        if (active_) due_.start();
    };
    connect(&session_.document(), &Document::changed, this, changed);
    connect(&session_.document(), &Document::analysisChanged, this, changed);
    connect(&session_.document(), &Document::opened, this, [this] {
        jobs_.cancel();
        values_.reset();
        select(std::nullopt);
        setCurrent(std::nullopt);
        Q_EMIT valuesChanged();
    });
    connect(&session_.transport(), &Transport::moved, this, &GraphSession::followPlayhead);
    connect(&session_, &Session::takeChanged, this, &GraphSession::followPlayhead);
    connect(&session_, &Session::activePlayerChanged, this, &GraphSession::optionsChanged);
}

void GraphSession::setActive(bool active) {
    active_ = active;
    if (active_ && stale_) due_.start();
    followPlayhead();
}

void GraphSession::learn() {
    const Document& document = session_.document();
    if (!active_ || !document.isOpen()) return;
    if (!document.isCurrent()) return;  // the analysis that is being made will tell
    stale_ = false;
    jobs_.start(
        tr("Learning transitions"),
        [project = document.project(), analysis = document.analysis(), options = options_,
         last = values_](const Progress& progress) {
            return learnt(project, analysis, options, last.get(), progress);
        },
        [this](GraphValues values) { take(std::move(values)); });
}

void GraphSession::take(GraphValues values) {
    const auto before = values_;
    values_ = std::make_shared<const GraphValues>(std::move(values));
    if (before && selection_ && before->interaction.graph != values_->interaction.graph) {
        setCurrent(std::nullopt);
        selection_ = carried(*selection_, *before->interaction.graph, graph());
        selected_ = selection_ ? behind(graph(), *selection_) : std::vector<int>{};
    }
    moments_ = {};
    Q_EMIT valuesChanged();
    Q_EMIT selectionChanged();
    followPlayhead();
}

QString GraphSession::nameOf(int player, int node) const {
    if (node == kAnyNode) return tr("anything");
    return shortLabelWords(*graph().vocabulary, graph().node(player, node).label);
}

void GraphSession::setOptions(const GraphOptions& options) {
    if (options == options_) return;
    const bool learnAnew = options.estimator != options_.estimator ||
                           options.versus != options_.versus ||
                           options.versusEstimator != options_.versusEstimator;
    options_ = options;
    Q_EMIT optionsChanged();
    if (learnAnew && active_) due_.start();
}

void GraphSession::setSurpriseKind(SurpriseKind kind) {
    if (kind == surpriseKind_) return;
    surpriseKind_ = kind;
    Q_EMIT surpriseKindChanged();
}

bool GraphSession::compares() const {
    if (!hasGraph()) return false;
    return options_.versus == Versus::OtherFighter ||
           (options_.versus != Versus::Nothing && values_->other.has_value());
}

std::array<GraphSide, 2> GraphSession::sides() const {
    const auto estimator = [](const Interaction& source) {
        const auto name = estimatorName(source.settings.estimator);
        return QString::fromLatin1(name.data(), qsizetype(name.size()));
    };
    const Interaction& first = values_->interaction;
    switch (compares() ? options_.versus : Versus::Nothing) {
        case Versus::OtherFighter:
            // Fighter 1 stays at the left, whoever is the active one.
            return {GraphSide{&first, 0, fighterText(0)}, GraphSide{&first, 1, fighterText(1)}};
        case Versus::HandLabels:
            return {GraphSide{&first, mover(), tr("all labels")},
                    GraphSide{&*values_->other, mover(), tr("labels by hand")}};
        case Versus::Estimator:
            return {GraphSide{&first, mover(), estimator(first)},
                    GraphSide{&*values_->other, mover(), estimator(*values_->other)}};
        case Versus::Nothing:
            break;
    }
    const GraphSide alone{&first, mover(), estimator(first)};
    return {alone, alone};
}

void GraphSession::select(std::optional<GraphSelection> selection) {
    if (selection == selection_) return;
    selection_ = selection;
    selected_ = selection_ && hasGraph() ? behind(graph(), *selection_) : std::vector<int>{};
    if (selection_) session_.setActivePlayer(selection_->mover);
    Q_EMIT selectionChanged();
}

void GraphSession::setCurrent(std::optional<TransitionRef> transition) {
    if (transition == current_) return;
    current_ = transition;
    Q_EMIT currentChanged();
}

Moment GraphSession::decisionOf(const TransitionRef& transition) const {
    const TransitionPlace place = placeOf(transition);
    return momentAt(values_->analysis, values_->interaction, place.take, place.frame,
                    transition.mover);
}

std::vector<NextLabel> GraphSession::candidates(int mover, const Moment& moment) const {
    return nextLabels(values_->interaction, mover, moment);
}

void GraphSession::followPlayhead() {
    if (!active_ || !hasGraph()) return;
    bool changed = false;
    for (const int mover : {0, 1}) {
        GraphMoment& moment = moments_[static_cast<std::size_t>(mover)];
        const int action =
            session_.fighter(mover) == nullptr
                ? -1
                : actionIndexAt(graph(), mover, session_.take(), session_.shownFrame(mover));
        if (action == moment.action) continue;
        changed = true;
        moment = {action, {}, kAnyNode};
        if (action < 0) continue;
        const BasicAction& own = graph().action(mover, action);
        moment.decision =
            momentAt(values_->analysis, values_->interaction, own.take, own.frames.end, mover);
        if (own.next >= 0) moment.next = graph().action(mover, own.next).node;
    }
    if (changed) Q_EMIT momentChanged();
}

const Transition& GraphSession::transitionOf(const TransitionRef& transition) const {
    return graph().transitionsOf(transition.mover)[static_cast<std::size_t>(transition.index)];
}

const Surprise& GraphSession::surpriseOf(const TransitionRef& transition) const {
    return values_->surprises[static_cast<std::size_t>(transition.mover)]
                             [static_cast<std::size_t>(transition.index)];
}

TransitionPlace GraphSession::placeOf(const TransitionRef& transition) const {
    return kumite::placeOf(graph(), transition.mover, transitionOf(transition));
}

/// The timeline is led to both actions of a transition, in a loop: Space plays them.
void GraphSession::show(const TransitionRef& transition) {
    const Transition& t = transitionOf(transition);
    const BasicAction& own = graph().action(transition.mover, t.own);
    const BasicAction& next = graph().action(transition.mover, t.next);
    if (own.take != session_.take()) session_.setTake(own.take);
    Transport& transport = session_.transport();
    session_.setActivePlayer(transition.mover);
    session_.selectAction(ActionRef{transition.mover, next.frames.peak});
    transport.setLoop(own.beginSeconds, next.endSeconds);
    transport.setLooping(true);
    setCurrent(transition);
}

void GraphSession::play(const TransitionRef& transition) {
    show(transition);
    const Transition& t = transitionOf(transition);
    const double begin = graph().action(transition.mover, t.own).beginSeconds;
    const double end = graph().action(transition.mover, t.next).endSeconds;
    Transport& transport = session_.transport();
    transport.setPlayhead(begin);
    const double air = 0.5 * (end - begin);
    session_.setVisible({begin - air, end + air});
    if (transport.speed() <= 0) transport.setSpeed(1);
    transport.setPlaying(true);
}

void GraphSession::playNext() {
    if (selected_.empty()) return;
    auto next = selected_.begin();
    if (current_ && current_->mover == selection_->mover) {
        const auto now = std::find(selected_.begin(), selected_.end(), current_->index);
        if (now != selected_.end() && now + 1 != selected_.end()) next = now + 1;
    }
    play({selection_->mover, *next});
}

void GraphSession::goTo(const TransitionRef& transition) {
    const Transition& t = transitionOf(transition);
    select(GraphSelection{transition.mover, {t.ownNode, t.opponentNode, t.nextNode}});
    session_.transport().setPlaying(false);
    show(transition);
    const double seconds = placeOf(transition).seconds;
    session_.transport().setPlayhead(seconds);
    session_.reveal(seconds);
}

std::vector<TransitionRef> GraphSession::bySurprise() const {
    std::vector<TransitionRef> order;
    const auto surprise = [this](const TransitionRef& t) { return shownSurprise(t); };
    for (const int mover : {0, 1}) {
        const auto& all = graph().transitionsOf(mover);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (graph().action(mover, all[i].own).take != session_.take()) continue;
            order.push_back({mover, static_cast<int>(i)});
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto& a, const auto& b) { return surprise(a) > surprise(b); });
    return order;
}

void GraphSession::stepSurprise(int direction) {
    if (!hasGraph()) return;
    const std::vector<TransitionRef> order = bySurprise();
    if (order.empty()) return;
    const auto count = static_cast<std::ptrdiff_t>(order.size());
    // From elsewhere the first step leads to the greatest, the first step back to the smallest.
    const bool walking = current_ && current_ == steppedTo_;
    const auto found = walking ? std::find(order.begin(), order.end(), *current_) : order.end();
    std::ptrdiff_t next = direction > 0 ? 0 : count - 1;
    if (found != order.end()) next = (found - order.begin() + direction + count) % count;
    goTo(order[static_cast<std::size_t>(next)]);
    steppedTo_ = current_;
}

}  // namespace kumite::studio
