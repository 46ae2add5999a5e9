#pragma once

#include <QObject>
#include <QTimer>

#include <optional>

#include <Eigen/Core>

namespace kumite::studio {

class BoutSession;
class StageView;

/// Shows the bout in the 3D view in the take's place while the Bout workspace is shown, and leads
/// what the pointer does on the floor to the avatar.
class BoutStage : public QObject {
    Q_OBJECT

public:
    BoutStage(BoutSession& bout, StageView& stage, QObject* parent);

private:
    void begin();
    void show();
    void showMark();
    bool isShown() const;

    BoutSession& bout_;
    StageView& stage_;
    std::optional<Eigen::Vector2d> pointed_;  ///< where the pointer is on the floor
    bool framed_ = false;                     ///< the camera was put where it sees this bout
};

}  // namespace kumite::studio
