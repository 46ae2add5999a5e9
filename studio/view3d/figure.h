#pragma once

#include <QColor>

#include <vector>

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include "studio/view3d/floor_shadow.h"
#include "studio/view3d/mesh_actor.h"
#include "studio/view3d/overlays.h"
#include "studio/view3d/pose.h"

class vtkRenderer;

namespace kumite::studio {

/// Half the thickness of a foot: how far below the toe joints the soles, and so the drawn floor,
/// lie.
inline constexpr float kSole = 0.028F;

/// The shadow of a body on the floor.
class ShadowActor {
public:
    /// `layer` 0, 1, …: shadows of one place lie upon one another in this order.
    ShadowActor(vtkRenderer* renderer, int layer);

    /// 0 … 1.
    void setStrength(double strength) { strength_ = strength; }
    void show(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints);
    void hide() { actor_->VisibilityOff(); }

private:
    double strength_ = 0.4;
    int layer_;
    FloorShadow shadow_;
    vtkNew<vtkImageData> picture_;
    vtkNew<vtkActor> actor_;
};

/// A fighter in the scene: body, shadow, and what the overlays say. The left arm and leg are
/// lighter: which side strikes is seen from everywhere.
class Figure {
public:
    /// Metres that the arrow of one body weight is long.
    static constexpr float kMetresPerBodyWeight = 0.5F;

    Figure(vtkRenderer* renderer, int player);

    void setColours(const QColor& body, const QColor& marker, double shadow);
    void show(const std::vector<Bone>& bones, const FigurePose& pose, const Overlays& overlays);
    void hide();

private:
    void showForce(const FigurePose& pose, const Overlays& overlays);
    void showContacts(const FigurePose& pose);
    void showTrails(const FigurePose& pose);

    Mesh mesh_;
    ShadowActor shadow_;
    MeshActor body_;  ///< all but the left limbs
    MeshActor left_;
    MeshActor force_;
    MeshActor contacts_;
    MeshActor trails_;
};

}  // namespace kumite::studio
