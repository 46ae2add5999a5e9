#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "studio/app/theme.h"
#include "studio/view3d/camera_controller.h"
#include "studio/view3d/figure.h"
#include "studio/view3d/floor.h"
#include "studio/view3d/ghost.h"

class vtkRenderer;

namespace kumite::studio {

/// The scene: floor, light, two fighters and ghosts of both.
class Stage {
public:
    explicit Stage(vtkRenderer* renderer);

    Figure& figure(int player) { return figures_[static_cast<std::size_t>(player)]; }
    Floor& floor() { return floor_; }
    /// `active` is the player who is drawn brighter, -1 for none.
    void setColours(const Colours& colours, int active);
    void setCamera(const CameraController& camera);

    /// A fighter at another moment, beside those that are there.
    void addGhost(int player, const std::vector<Bone>& bones,
                  const std::vector<Eigen::Vector3f>& joints);
    void clearGhosts();

    /// A mark on the floor (x and z, metres) in the colour of what has the focus.
    void setFloorMark(const std::optional<Eigen::Vector2d>& place, bool faint);

private:
    struct PlayerGhost {
        int player;
        Ghost ghost;
    };

    vtkRenderer* renderer_;
    const Colours* colours_ = nullptr;
    Floor floor_;
    MeshActor mark_;  ///< before the figures, who stand on it
    std::array<Figure, 2> figures_;
    // Actors are kept for the next ghosts; the first `ghostCount_` are shown.
    std::deque<PlayerGhost> ghosts_;
    std::size_t ghostCount_ = 0;
};

}  // namespace kumite::studio
