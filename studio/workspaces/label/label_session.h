#pragma once

#include <QObject>

#include <span>
#include <vector>

#include "core/labelling/answers.h"
#include "studio/app/session.h"
#include "studio/workspaces/label/label_learning.h"
#include "studio/workspaces/label/shown_action.h"

namespace kumite::studio {

/// How far the labelling of the whole project has come.
struct LabelProgress {
    int actions = 0;
    int byHand = 0;    ///< a hand said something
    int accepted = 0;  ///< not by hand, but the document knows something
    int settled = 0;   ///< the document knows every aspect
    std::optional<double> expectedAccuracy;
    bool mayStop = false;  ///< more labels by hand will hardly help

    double labelledShare() const {
        return actions > 0 ? static_cast<double>(byHand + accepted) / actions : 0.0;
    }
};

/// What was expected after so many labels.
struct LearnedPoint {
    int labelled = 0;
    double expectedAccuracy = 0;
};

/// In which order open actions are asked about.
enum class QueueOrder { MostUseful, LeastSure, Time };

/// A labelling session: every action with its label and where it comes from, what machine and
/// rules propose beside it, the queue of questions, how far it has come, and the edits that hands
/// make. Proposals are no part of the document until they are accepted. No widgets; belongs to the
/// GUI thread. Actions are those of all takes; an ActionRef is one of the shown take.
class LabelSession : public QObject {
    Q_OBJECT

public:
    explicit LabelSession(Session& session, QObject* parent = nullptr);

    /// The workspace is shown. Until then nothing is computed.
    void setActive(bool active);
    bool isActive() const { return learning_.isActive(); }

    Session& session() { return session_; }
    const Vocabulary& vocabulary() const;

    // What is shown.

    const std::vector<ShownAction>& actions() const { return actions_; }
    /// A player's of the shown take, in order of time.
    std::span<const ShownAction> actionsOf(int player) const;
    const ShownAction* find(const ActionRef& action) const;
    /// Index into `actions`; -1 where there is no such action.
    int indexOf(FighterAddress fighter, int peak) const;
    /// The selected action, else that of the active fighter at the playhead.
    const ShownAction* current() const;
    /// When the peak of an action is, seconds on its take's clock.
    double timeOf(const ShownAction& action) const;
    /// Why rules say what they say; null until they have spoken.
    const RuleReasons* reasonsOf(const ShownAction& action) const;
    /// What machine and rules found; null at first. Its rows are found by `learnt()->ground`.
    const std::shared_ptr<const LearntLabels>& learnt() const { return learning_.learnt(); }
    bool isLearning() const { return learning_.isBusy(); }
    /// The proposals belong to the newest labels; with `thoroughly` they are calibrated, too.
    bool isCurrent(bool thoroughly = false) const { return learning_.isCurrent(thoroughly); }

    const LabelProgress& progress() const { return progress_; }
    const std::vector<LearnedPoint>& curve() const { return curve_; }

    // The queue: open actions, indices into `actions`.

    const std::vector<int>& queue() const { return queue_; }
    QueueOrder order() const { return order_; }
    void setOrder(QueueOrder order);
    const QuerySettings& querySettings() const { return learning_.querySettings(); }
    void setQuerySettings(const QuerySettings& settings) { learning_.setQuerySettings(settings); }

    // What is chosen.

    /// Shows an action of any take, makes it the current one and forgets what else was chosen.
    void goTo(const ShownAction& action);
    /// All chosen actions, in order: the current one and those chosen with it.
    std::vector<int> chosen() const;
    /// The same, in the order in which they were chosen.
    std::vector<ActionRef> chosenRefs() const;
    /// Chooses several; the last one becomes the current one.
    void choose(std::vector<ActionRef> actions);
    /// The aspect whose qualifiers the number keys set.
    int aspect() const { return aspect_; }
    void setAspect(int aspect);

    // Edits: each one step of the history; false where nothing changed. Actions by index.

    /// A hand names one qualifier; see answeredLabel for what becomes of the other aspects.
    bool name(std::span<const int> actions, int aspect, int qualifier,
              Naming naming = Naming::Instead);
    /// A hand says whole labels; aspects that `label` leaves unknown stay as they are.
    bool say(std::span<const int> actions, const Label& label);
    /// The same with a label of its own for each.
    bool sayEach(std::span<const std::pair<int, Label>> answers);
    /// A hand agrees with what is shown.
    bool agree(std::span<const int> actions);
    /// Takes back whatever was said or accepted; of one aspect, or of all.
    bool clear(std::span<const int> actions, std::optional<int> aspect = {});
    /// Names a qualifier of one action after the other, all of them one step of the history until
    /// `endPainting`.
    void paint(int action, int aspect, int qualifier);
    void endPainting();
    /// While it is on, what is said is one step of the history: two classes of one action.
    void setTogether(bool together);
    /// How many actions without a hand's label are as sure as that in every aspect.
    int countSure(double leastConfidence) const;
    /// Accepts those, and what rules say of actions that hands labelled. Not while `isCurrent
    /// (true)` is false.
    bool acceptSure(double leastConfidence);

Q_SIGNALS:
    /// Labels, proposals, progress or queue are others.
    void changed();
    /// The current action, those chosen with it, or the chosen aspect.
    void choiceChanged();
    /// A step of the history that changed this action was undone or redone.
    void stepped(int action);
    void learningChanged();

private:
    void refresh();
    void rebuild();
    void rebuildQueue();
    void count();
    void notePoint();
    void followHistory(const Project& before);
    void followSelection();
    const std::vector<ActionLabel>* proposalsOf(FighterAddress fighter,
                                                const std::vector<RuleReasons>** reasons) const;
    bool edit(const std::function<MaybeEdit(const Project&, const Analysis&)>& function);
    bool set(const std::vector<ActionAnswer>& answers);
    bool answer(std::span<const int> actions,
                const std::function<Label(const ShownAction&)>& labelOf);
    /// What is accepted from that confidence on.
    std::vector<FighterLabels> sureProposals(double leastConfidence) const;

    Session& session_;
    LabelLearning learning_;
    std::vector<ShownAction> actions_;
    /// Where the actions of each fighter that has some begin, in order of takes and players.
    std::vector<std::size_t> begins_;
    std::vector<int> queue_;
    std::vector<std::pair<FighterAddress, int>> batch_;  ///< asked about together, by peaks
    QueueOrder order_ = QueueOrder::MostUseful;
    LabelProgress progress_;
    std::vector<LearnedPoint> curve_;
    std::vector<ActionRef> chosen_;  ///< beside the current action
    int aspect_ = 0;
    std::vector<ActionAnswer> painted_;
    bool together_ = false;
};

}  // namespace kumite::studio
