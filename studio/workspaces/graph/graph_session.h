#pragma once

#include <QObject>
#include <QTimer>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/interaction/graph_layout.h"
#include "core/interaction/surprise.h"
#include "core/interaction/transition_table.h"
#include "core/project/interaction.h"
#include "studio/app/session.h"

namespace kumite::studio {

/// What is learnt from the labels as they are now: all that the Graph workspace shows.
struct GraphValues {
    Interaction interaction;
    /// How unexpected each transition is, by mover.
    std::array<std::vector<Surprise>, 2> surprises;
    GraphLayout layout;
    /// What the first is compared with, where that is another model.
    std::optional<Interaction> other;
    Analysis analysis;   ///< what all of it was learnt from
    QString whyNothing;  ///< what to do where there is nothing to show; else empty
};

/// What the transitions are compared with.
enum class Versus { Nothing, OtherFighter, Estimator, HandLabels };

/// How the transitions are looked at; the same for all views of the workspace.
struct GraphOptions {
    LabelEstimator estimator = LabelEstimator::Equ7;
    Versus versus = Versus::Nothing;
    LabelEstimator versusEstimator = LabelEstimator::Equ5;

    bool operator==(const GraphOptions&) const = default;
};

/// One of two that are looked at side by side: whose transitions, by which model.
struct GraphSide {
    const Interaction* source = nullptr;
    int mover = 0;
    QString name;

    const CoupledGraph& graph() const { return *source->graph; }
    const TransitionModel& model() const {
        return *source->models[static_cast<std::size_t>(mover)];
    }
};

/// What somebody wants to look behind: transitions of a mover.
struct GraphSelection {
    int mover = 0;
    TransitionFilter filter;
};
bool operator==(const GraphSelection& a, const GraphSelection& b);

/// The decision that a fighter comes to next after the playhead: at the end of its action, given
/// what the opponent will be doing then.
struct GraphMoment {
    int action = -1;      ///< the mover's action at the playhead, of B; -1: none
    Moment decision;      ///< at that action's end
    int next = kAnyNode;  ///< what the mover really does after it
};

/// A transition that was observed: of which mover, and which of its transitions.
struct TransitionRef {
    int mover = 0;
    int index = 0;

    bool operator==(const TransitionRef&) const = default;
};

/// What the Graph workspace looks at: the graph learnt from the document, kept up to date in the
/// background while the workspace is shown, the chosen options, what is selected and what is going
/// on at the playhead. Its views listen to it. The mover is the session's active fighter.
class GraphSession : public QObject {
    Q_OBJECT

public:
    explicit GraphSession(Session& session, QObject* parent = nullptr);

    Session& session() { return session_; }
    const Session& session() const { return session_; }
    JobRunner& jobs() { return jobs_; }
    bool isLearning() const { return jobs_.isRunning() || due_.isActive(); }
    /// Learns only while somebody looks; catches up when somebody does again.
    void setActive(bool active);
    bool isActive() const { return active_; }

    /// Null until learnt for the first time.
    const GraphValues* values() const { return values_.get(); }
    /// The same for who shows them on after others were learnt.
    std::shared_ptr<const GraphValues> sharedValues() const { return values_; }
    /// Whether there is any transition to look at.
    bool hasGraph() const { return values_ != nullptr && values_->whyNothing.isEmpty(); }
    const CoupledGraph& graph() const { return *values_->interaction.graph; }
    const TransitionModel& model(int mover) const {
        return *values_->interaction.models[static_cast<std::size_t>(mover)];
    }
    /// A node's label as people read it.
    QString nameOf(int player, int node) const;

    int mover() const { return std::clamp(session_.activePlayer(), 0, 1); }
    const GraphOptions& options() const { return options_; }
    void setOptions(const GraphOptions& options);
    /// Which surprise is looked at.
    SurpriseKind surpriseKind() const { return surpriseKind_; }
    void setSurpriseKind(SurpriseKind kind);

    /// Whether two are compared: both fighters, or the mover by two models.
    bool compares() const;
    /// The two that are compared; where nothing is, the mover twice.
    std::array<GraphSide, 2> sides() const;

    const std::optional<GraphSelection>& selection() const { return selection_; }
    void select(std::optional<GraphSelection> selection);
    /// The transitions behind what is selected, in order of time. Where both labels are given and
    /// never led there together, those that share the own label, else the opponent's.
    const std::vector<int>& selected() const { return selected_; }

    const GraphMoment& moment(int mover) const { return moments_[static_cast<std::size_t>(mover)]; }
    /// The decision that a transition was.
    Moment decisionOf(const TransitionRef& transition) const;
    /// What a mover may do next there, the likeliest first.
    std::vector<NextLabel> candidates(int mover, const Moment& moment) const;

    /// Where a transition stands.
    TransitionPlace placeOf(const TransitionRef& transition) const;
    const Transition& transitionOf(const TransitionRef& transition) const;
    const Surprise& surpriseOf(const TransitionRef& transition) const;
    /// Of the kind that is looked at, nats.
    double shownSurprise(const TransitionRef& transition) const {
        return valueOf(surpriseOf(transition), surpriseKind_);
    }
    /// Shows a transition's two actions and plays them in a loop.
    void play(const TransitionRef& transition);
    /// Plays the first of what is selected, then the next at each call, round at the end.
    void playNext();
    /// Moves the playhead to a transition and selects what is behind it.
    void goTo(const TransitionRef& transition);
    std::optional<TransitionRef> current() const { return current_; }
    /// The next (+1) less or (-1) more surprising transition of the shown take.
    void stepSurprise(int direction);

Q_SIGNALS:
    /// Another graph (or none) is shown.
    void valuesChanged();
    /// Options or mover.
    void optionsChanged();
    void surpriseKindChanged();
    void selectionChanged();
    /// Another transition is the one that is looked at.
    void currentChanged();
    /// Another action is going on at the playhead.
    void momentChanged();

private:
    void show(const TransitionRef& transition);
    void learn();
    void take(GraphValues values);
    void followPlayhead();
    void setCurrent(std::optional<TransitionRef> transition);
    std::vector<TransitionRef> bySurprise() const;

    Session& session_;
    JobRunner jobs_;
    QTimer due_;
    std::shared_ptr<const GraphValues> values_;
    GraphOptions options_;
    SurpriseKind surpriseKind_ = SurpriseKind::Both;
    std::optional<GraphSelection> selection_;
    std::vector<int> selected_;
    std::optional<TransitionRef> current_;
    std::optional<TransitionRef> steppedTo_;  ///< the surprise that the last step led to
    std::array<GraphMoment, 2> moments_;
    bool active_ = false;
    bool stale_ = true;  ///< the document changed since the values were learnt
};

/// A label in the fewest words that tell it, for tables and drawings: "right punch fwd, L-R".
QString shortLabelWords(const Vocabulary& vocabulary, const Label& label);

/// All that is known of a transition's surprise, for a line or a tip.
QString surpriseWords(const Surprise& surprise);
/// "both", "label", "geometry".
QString surpriseName(SurpriseKind kind);

/// A selection in one graph as the same labels of another; nothing where these are not there.
std::optional<GraphSelection> carried(const GraphSelection& selection, const CoupledGraph& from,
                                      const CoupledGraph& to);

/// The project with the labels of hands alone.
Project withHandLabels(const Project& project);

}  // namespace kumite::studio
