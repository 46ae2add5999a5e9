#pragma once

#include <QColor>
#include <QObject>
#include <QString>

#include <cstdint>
#include <span>
#include <vector>

#include "studio/app/session.h"

namespace kumite::studio {

/// How a cell of a lane is painted.
enum class LaneLook : std::uint8_t {
    Open,      ///< nothing is known: empty
    Nothing,   ///< "nothing of it": the ground, a line where a hand said so
    Hand,      ///< solid
    Accepted,  ///< lighter
    Proposed,  ///< lighter still
    Rule,      ///< outlined
};

/// What a lane shows of one action.
struct LaneCell {
    std::int8_t value = -1;  ///< what it says, counted by the lane; -1: nothing known
    LaneLook look = LaneLook::Open;
    bool uncertain = false;  ///< hatched
    bool byHand = false;

    bool operator==(const LaneCell&) const = default;
};

/// Rows of coloured blocks under each fighter's actions, for the timeline: one cell per action and
/// lane. A workspace brings them.
class LaneSource : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    virtual int laneCount() const = 0;
    virtual QString laneName(int lane) const = 0;
    /// The lane that keys write to; -1: none.
    virtual int chosenLane() const = 0;
    /// What a value reads in a block, short, and its colour as the vocabulary has it.
    virtual QString valueText(int lane, int value) const = 0;
    virtual QColor valueColour(int lane, int value) const = 0;
    /// A player's cells, action by action and in it lane by lane; empty while nothing is known.
    virtual std::span<const LaneCell> cells(int player) const = 0;
    /// All that is chosen, with the selected action.
    virtual std::vector<ActionRef> chosen() const = 0;
    /// What the pointer is on: label, source, confidence, reason.
    virtual QString describe(const ActionRef& action, int lane) const = 0;

    // What the mouse does. `lane` -1: on the strip of actions.

    /// True where the playhead should go to the pointer.
    virtual bool pressed(const ActionRef& action, int lane, Qt::KeyboardModifiers modifiers) = 0;
    /// The pointer is dragged on over another action.
    virtual void dragged(const ActionRef& action) = 0;
    virtual void released() = 0;

Q_SIGNALS:
    /// Cells, names or choice are others.
    void changed();
};

}  // namespace kumite::studio
