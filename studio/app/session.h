#pragma once

#include <QObject>

#include <optional>
#include <vector>

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

/// What the user looks at: the document, which take of it, the playhead, the active fighter, the
/// selected boundary and the visible stretch of time. Every view listens to it; nothing in it but
/// the document is ever undone or saved.
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

    /// Visible stretch of the timeline, seconds.
    TimeSpan visible() const { return visible_; }
    void setVisible(TimeSpan span);
    void showAll();
    /// Scrolls so that a moment is visible.
    void reveal(double seconds);

    // Edits, on behalf of all views. Each is one step of the history.

    /// Removes a live boundary, restores a removed one.
    void toggleBoundary(const BoundaryRef& boundary);
    /// The same for the selected boundary, else the one at the playhead.
    void toggleCurrentBoundary();
    void addBoundaryAtPlayhead();
    void moveBoundary(const BoundaryRef& boundary, int toFrame);
    /// Joins the active fighter's action at the playhead with the one before (-1) or after (+1).
    void mergeAction(int direction);

    // Steps of the playhead.

    /// By frames of the active fighter.
    void stepFrames(int count);
    /// To the next (+1) or previous (-1) live boundary of the active fighter.
    void stepBoundary(int direction);

Q_SIGNALS:
    /// Another take is shown (or another document).
    void takeChanged();
    /// Curves, minima or boundaries of the shown take changed.
    void fightersChanged();
    void activePlayerChanged();
    void selectionChanged();
    void visibleChanged();
    /// One line for the status bar: what the pointer is on; empty: nothing.
    void hovered(const QString& text);
    /// Something could not be done, in one quiet sentence.
    void hinted(const QString& sentence);

private:
    FighterAddress address(int player) const { return {take_, player}; }
    void opened();
    void followTake();
    void stretchSpan();
    void refreshMarks();
    void keepSelection();

    Document document_;
    Transport transport_;
    int take_ = 0;
    std::string takeName_;  ///< by which the shown take is found again after it was moved
    int activePlayer_ = 0;
    std::optional<BoundaryRef> selection_;
    TimeSpan visible_{0, 1};
    std::vector<std::vector<BoundaryMark>> marks_;
    int knownTakes_ = 0;    ///< how many takes there were when `takeName_` was noted
    bool awaited_ = false;  ///< the shown take has no values yet
};

}  // namespace kumite::studio
