#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/segmentation/boundary_comparison.h"
#include "studio/app/boundary_marks.h"
#include "studio/app/document.h"
#include "studio/app/transport.h"

namespace kumite::studio {

/// A boundary of a player of the shown take, by its frame.
struct BoundaryRef {
    int player = 0;
    int frame = 0;

    bool operator==(const BoundaryRef&) const = default;
};

/// An action of a player of the shown take, by its peak.
struct ActionRef {
    int player = 0;
    int peak = 0;

    bool operator==(const ActionRef&) const = default;
};

/// A second way to cut the shown take, beside the project's own: what boundaries it gives.
struct Comparison {
    SegmentationSettings settings;
    std::vector<BoundaryComparison> players;  ///< A: the project's settings, B: these
};

/// What the user looks at: the document, which take of it, the playhead, the active fighter, the
/// selected boundary or action and the visible stretch of time. Every view listens to it; nothing
/// in it but the document is ever undone or saved.
class Session : public QObject {
    Q_OBJECT

public:
    explicit Session(QObject* parent = nullptr);

    Document& document() { return document_; }
    const Document& document() const { return document_; }
    Transport& transport() { return transport_; }
    const Transport& transport() const { return transport_; }

    int take() const { return take_; }
    void setTake(int take);
    /// Fighters of the shown take.
    int playerCount() const;
    /// Derived values of a player; null where there is no such player or its recording is missing.
    const FighterAnalysis* fighter(int player) const;
    const std::vector<BoundaryMark>& marks(int player) const;
    /// The frame of a player that is shown now, and the moment at which a frame is shown.
    int shownFrame(int player) const;
    double timeOf(const BoundaryRef& boundary) const;

    int activePlayer() const { return activePlayer_; }
    void setActivePlayer(int player);

    const std::optional<BoundaryRef>& selection() const { return selection_; }
    void select(std::optional<BoundaryRef> boundary);
    /// Selects, makes its fighter active and moves the playhead there.
    void goTo(const BoundaryRef& boundary);
    /// The same, shown from near and in the middle, so that it can be judged.
    void examine(const BoundaryRef& boundary);

    /// A boundary and an action are never selected together.
    const std::optional<ActionRef>& selectedAction() const { return selectedAction_; }
    void selectAction(std::optional<ActionRef> action);
    /// Null where there is no such action (any more).
    const Action* actionOf(const ActionRef& action) const;
    /// Which of the fighter's actions it is, from 0; -1 where there is none such.
    int numberOf(const ActionRef& action) const;
    /// The action of a player at a frame.
    std::optional<ActionRef> actionAt(int player, int frame) const;
    /// The selected action, else that of the active fighter at the playhead.
    std::optional<ActionRef> currentAction() const;
    TimeSpan spanOf(const ActionRef& action) const;
    /// What is noted about an action; empty: nothing.
    QString noteOf(const ActionRef& action) const;
    /// Shows an action with some air and plays it in a loop.
    void loopAction(const ActionRef& action);
    /// Shows what is selected, closely.
    void frameSelection();

    const std::optional<Comparison>& comparison() const { return comparison_; }
    void setComparison(std::optional<Comparison> comparison);

    /// Visible stretch of the timeline, seconds.
    TimeSpan visible() const { return visible_; }
    void setVisible(TimeSpan span);
    void showAll();
    /// Scrolls so that a moment is visible.
    void reveal(double seconds);

    // Edits, on behalf of all views. Each is one step of the history. While derived values are
    // being computed they wait for them (Document::whenCurrent).

    /// Runs what edits the shown take. Where it has to wait it says so, and it is dropped, in a
    /// sentence, if another take is shown by then.
    void whenCurrent(const std::function<void()>& act);

    /// Removes a boundary, or restores a removed one.
    void setBoundaryLive(const BoundaryRef& boundary, bool live);
    /// Removes a live boundary, restores a removed one.
    void toggleBoundary(const BoundaryRef& boundary);
    /// The same for the selected boundary, else the one at the playhead.
    void toggleCurrentBoundary();
    void addBoundaryAtPlayhead();
    void moveBoundary(const BoundaryRef& boundary, int toFrame);
    /// Joins the current action with the one before (-1) or after (+1).
    void mergeAction(int direction);
    /// Moves the selected boundary, else the one at the playhead, by frames.
    void nudgeBoundary(int frames);
    /// Says that a boundary is right; the same taken back.
    void acceptBoundary(const BoundaryRef& boundary);
    void withdrawAcceptance(const BoundaryRef& boundary);
    void setNote(const ActionRef& action, const QString& text);

    // Steps of the playhead.

    /// By frames of the active fighter.
    void stepFrames(int count);
    /// To the next (+1) or previous (-1) live boundary of the active fighter.
    void stepBoundary(int direction);
    /// Selects the active fighter's next (+1) or previous (-1) action.
    void stepAction(int direction);

Q_SIGNALS:
    /// A boundary is shown from near, to be judged.
    void examined();
    /// Another take is shown (or another document).
    void takeChanged();
    /// Curves, minima or boundaries of the shown take changed.
    void fightersChanged();
    void activePlayerChanged();
    void selectionChanged();
    void visibleChanged();
    void comparisonChanged();
    /// One line for the status bar: what the pointer is on; empty: nothing.
    void hovered(const QString& text);
    /// Something could not be done, in one quiet sentence; empty: that holds no more.
    void hinted(const QString& sentence);

private:
    FighterAddress address(int player) const { return {take_, player}; }
    void opened();
    void followTake();
    void stretchSpan();
    void refreshMarks();
    void keepSelection();
    /// The selected boundary, else the active fighter's nearest to the playhead; none: says so.
    std::optional<BoundaryRef> currentBoundary();

    Document document_;
    Transport transport_;
    int take_ = 0;
    std::string takeName_;  ///< by which the shown take is found again after it was moved
    int activePlayer_ = 0;
    std::optional<BoundaryRef> selection_;
    std::optional<ActionRef> selectedAction_;
    std::optional<Comparison> comparison_;
    TimeSpan visible_{0, 1};
    std::vector<std::vector<BoundaryMark>> marks_;
    int knownTakes_ = 0;    ///< how many takes there were when `takeName_` was noted
    bool awaited_ = false;  ///< the shown take has no values yet
};

}  // namespace kumite::studio
