#pragma once

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

#include "core/labelling/distances.h"
#include "studio/jobs/job_runner.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace kumite::studio {

class ActionTiles;
class LabelSession;
struct LearningGround;

/// The actions most like the current one as small views that loop in step, with what is said of
/// them; several of them get the current one's label as one step.
class SimilarBox : public QWidget {
    Q_OBJECT

public:
    explicit SimilarBox(LabelSession& labels, QWidget* parent);

    ActionTiles& tiles() { return *tiles_; }
    /// Indices into the session's actions, the current one first.
    const std::vector<int>& actions() const { return actions_; }
    /// Gives the chosen ones (none chosen: all) the current one's label, as said by a hand.
    void giveLabel();

Q_SIGNALS:
    /// Other actions are shown than before.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void follow();
    void measure();
    void showNearest();
    void showTiles();
    void showChoice();
    void open(int tile);

    LabelSession& labels_;
    ActionTiles* tiles_;
    QLabel* said_;
    QPushButton* give_;
    QCheckBox* opponent_;
    std::shared_ptr<const LearningGround> ground_;  ///< what `distances_` are about
    std::shared_ptr<const ActionDistances> distances_;
    bool mirrored_ = true;
    std::vector<int> actions_;
    std::vector<ActionDistances::Neighbour> nearest_;  ///< beside `actions_`
    std::vector<int> rows_;  ///< of the ground, of the actions in the tiles
    JobRunner jobs_;
};

}  // namespace kumite::studio
