#include "studio/view3d/ghost.h"

namespace kumite::studio {

Ghost::Ghost(vtkRenderer* renderer)
    : depth_(renderer, MeshActor::Surface::Flat), colour_(renderer, MeshActor::Surface::Body) {
    // Too little to change any pixel; VTK draws nothing at all of what has no opacity.
    depth_.setOpacity(0.001);
    colour_.setOpacity(0.30);
}

void Ghost::setColour(const QColor& colour) {
    colour_.setColour(colour);
}

void Ghost::show(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints) {
    Mesh mesh;
    buildBody(bones, joints, mesh);
    depth_.show(mesh);
    colour_.show(mesh);
}

void Ghost::hide() {
    depth_.hide();
    colour_.hide();
}

}  // namespace kumite::studio
