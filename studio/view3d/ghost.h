#pragma once

#include <QColor>

#include <vector>

#include "studio/view3d/mesh_actor.h"

class vtkRenderer;

namespace kumite::studio {

/// A fighter as it stood at another moment, translucent.
class Ghost {
public:
    explicit Ghost(vtkRenderer* renderer);

    void setColour(const QColor& colour);
    void show(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints);
    void hide();

private:
    // Twice the same body: first its depth alone, then its colour where it is in front, so that
    // the limbs inside do not shine through.
    MeshActor depth_;
    MeshActor colour_;
};

}  // namespace kumite::studio
