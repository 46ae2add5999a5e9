#pragma once

#include <array>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "studio/app/theme.h"
#include "studio/view3d/camera_controller.h"
#include "studio/view3d/figure.h"

class vtkRenderer;

namespace kumite::studio {

/// The scene: a floor grid of 1 m (fine lines every 0.5 m) that fades with distance, light, and
/// room for two fighters.
class Stage {
public:
    explicit Stage(vtkRenderer* renderer);

    Figure& figure(int player) { return figures_[static_cast<std::size_t>(player)]; }
    /// `active` is the player who is drawn brighter, -1 for none.
    void setColours(const Colours& colours, int active);
    /// Whether edges are smoothed.
    void setSmooth(bool smooth);
    /// The floor reaches at least over this box.
    void setFloor(const Box& box);
    void setCamera(const CameraController& camera);

private:
    void drawFloor();

    vtkRenderer* renderer_;
    const Colours* colours_ = nullptr;
    Eigen::Vector2d floorCentre_ = Eigen::Vector2d::Zero();
    double floorRadius_ = 5;
    vtkNew<vtkPolyData> floorData_;
    vtkNew<vtkActor> floor_;
    std::array<Figure, 2> figures_;
};

}  // namespace kumite::studio
