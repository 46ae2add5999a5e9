#include "studio/view3d/stage.h"

#include <vtkLight.h>
#include <vtkRenderer.h>

namespace kumite::studio {

namespace {

void addLight(vtkRenderer* renderer, double x, double y, double z, double intensity) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer->AddLight(light);
}

}  // namespace

Stage::Stage(vtkRenderer* renderer)
    : renderer_(renderer),
      floor_(renderer),
      mark_(renderer, MeshActor::Surface::Flat),
      figures_{Figure(renderer, 0), Figure(renderer, 1)} {
    renderer_->SetAutomaticLightCreation(false);
    // From above right, a fill from the left, and a rim from behind.
    addLight(renderer_, 0.5, 1.1, 0.9, 0.85);
    addLight(renderer_, -0.9, 0.2, 0.7, 0.40);
    addLight(renderer_, 0.2, 0.6, -1.0, 0.30);
}

void Stage::setColours(const Colours& colours, int active) {
    colours_ = &colours;
    const QColor& ground = colours.ground;
    renderer_->SetBackground(ground.redF(), ground.greenF(), ground.blueF());
    for (int player = 0; player < 2; ++player) {
        const QColor plain = colours.fighters[player];
        const double away = active < 0 || player == active ? 0.0 : colours.dark ? 0.20 : 0.12;
        const QColor body = mixed(plain, colours.ground, away);
        const QColor marker = mixed(plain, colours.text, 0.45);
        figure(player).setColours(body, marker, colours.dark ? 0.75 : 0.42);
    }
    for (PlayerGhost& ghost : ghosts_)
        ghost.ghost.setColour(colours.fighters[ghost.player]);
    floor_.setColours(colours);
    mark_.setColour(colours.accent);
}

void Stage::setFloorMark(const std::optional<Eigen::Vector2d>& place, bool faint) {
    if (!place) {
        mark_.hide();
        return;
    }
    const Eigen::Vector3f at(static_cast<float>(place->x()), 0, static_cast<float>(place->y()));
    const float height = -kSole + 0.007F;
    Mesh mesh;
    mesh.addFloorBand(at, at, 0.24F, 0.035F, height);
    mesh.addFloorBand(at, at, 0.05F, 0.05F, height);
    mark_.setOpacity(faint ? 0.45 : 1.0);
    mark_.show(mesh);
}

void Stage::setCamera(const CameraController& camera) {
    aim(*renderer_, camera, 0.02 * camera.distance(), camera.distance() + 2 * floor_.radius() + 20);
}

void Stage::addGhost(int player, const std::vector<Bone>& bones,
                     const std::vector<Eigen::Vector3f>& joints) {
    if (ghostCount_ == ghosts_.size()) ghosts_.push_back({player, Ghost(renderer_)});
    PlayerGhost& ghost = ghosts_[ghostCount_++];
    ghost.player = player;
    if (colours_ != nullptr) ghost.ghost.setColour(colours_->fighters[player]);
    ghost.ghost.show(bones, joints);
}

void Stage::clearGhosts() {
    for (PlayerGhost& ghost : ghosts_)
        ghost.ghost.hide();
    ghostCount_ = 0;
}

}  // namespace kumite::studio
