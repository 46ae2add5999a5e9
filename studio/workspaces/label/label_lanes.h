#pragma once

#include <array>
#include <vector>

#include "studio/timeline/lanes.h"
#include "studio/workspaces/label/label_review.h"

namespace kumite::studio {

/// The labels as lanes of the timeline: one per aspect.
class LabelLanes : public LaneSource {
    Q_OBJECT

public:
    LabelLanes(LabelSession& labels, LabelReview& review, QObject* parent);

    int laneCount() const override;
    QString laneName(int lane) const override;
    int chosenLane() const override;
    QString valueText(int lane, int value) const override;
    QColor valueColour(int lane, int value) const override;
    std::span<const LaneCell> cells(int player) const override;
    std::vector<ActionRef> chosen() const override;
    QString describe(const ActionRef& action, int lane) const override;
    bool pressed(const ActionRef& action, int lane, Qt::KeyboardModifiers modifiers) override;
    void dragged(const ActionRef& action) override;
    void released() override;

private:
    void fill();

    LabelSession& labels_;
    LabelReview& review_;
    std::array<std::vector<LaneCell>, 2> cells_;
    bool painting_ = false;
};

/// What a cell shows of an aspect.
LaneCell laneCell(const Aspect& aspect, const ShownAspect& shown);

}  // namespace kumite::studio
