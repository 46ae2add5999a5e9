#include "studio/view3d/figure.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>

#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

/// Heights of flat things, so that none hides another: grid, shadow, bands.
constexpr float kShadowHeight = -kSole + 0.002F;
constexpr float kBandHeight = -kSole + 0.006F;
/// How much of white the left limbs have.
constexpr double kLighter = 0.42;

/// A square of side 1 about the origin of the floor, with the picture's corners.
vtkNew<vtkPolyData> unitSquare() {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> corners;
    corners->SetNumberOfComponents(2);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(4);
    for (const auto& [x, z] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        points->InsertNextPoint(0.5 * x, 0, 0.5 * z);
        corners->InsertNextTuple2(0.5 + 0.5 * x, 0.5 + 0.5 * z);
        cells->InsertCellPoint(points->GetNumberOfPoints() - 1);
    }
    vtkNew<vtkPolyData> square;
    square->SetPoints(points);
    square->SetPolys(cells);
    square->GetPointData()->SetTCoords(corners);
    return square;
}

}  // namespace

ShadowActor::ShadowActor(vtkRenderer* renderer, int layer) : layer_(layer) {
    picture_->SetDimensions(FloorShadow::kCells, FloorShadow::kCells, 1);
    picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(picture_);
    texture->InterpolateOn();
    texture->RepeatOff();
    texture->EdgeClampOn();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(unitSquare());
    actor_->SetMapper(mapper);
    actor_->SetTexture(texture);
    actor_->GetProperty()->LightingOff();
    actor_->ForceOpaqueOn();
    actor_->VisibilityOff();
    renderer->AddActor(actor_);
}

void ShadowActor::show(const std::vector<Bone>& bones, const std::vector<Eigen::Vector3f>& joints) {
    castShadow(bones, joints, -kSole, shadow_);
    auto* texel = static_cast<unsigned char*>(picture_->GetScalarPointer());
    for (const std::uint8_t darkness : shadow_.darkness) {
        texel[0] = texel[1] = texel[2] = 0;
        texel[3] = static_cast<unsigned char>(strength_ * darkness);
        texel += 4;
    }
    picture_->Modified();
    actor_->SetPosition(shadow_.centre.x(), kShadowHeight + 0.001 * layer_, shadow_.centre.y());
    actor_->SetScale(shadow_.extent, 1, shadow_.extent);
    actor_->VisibilityOn();
}

Figure::Figure(vtkRenderer* renderer, int player)
    : shadow_(renderer, player),
      body_(renderer, MeshActor::Surface::Body),
      left_(renderer, MeshActor::Surface::Body),
      force_(renderer, MeshActor::Surface::Marker),
      contacts_(renderer, MeshActor::Surface::Flat),
      trails_(renderer, MeshActor::Surface::Marker) {}

void Figure::setColours(const QColor& body, const QColor& marker, double shadow) {
    body_.setColour(body);
    left_.setColour(mixed(body, Qt::white, kLighter));
    for (MeshActor* actor : {&force_, &contacts_, &trails_})
        actor->setColour(marker);
    shadow_.setStrength(shadow);
}

void Figure::show(const std::vector<Bone>& bones, const FigurePose& pose,
                  const Overlays& overlays) {
    if (pose.joints.empty()) {
        hide();
        return;
    }
    buildBody(bones, pose.joints, mesh_, BodyPart::AllButLeftLimbs);
    body_.show(mesh_);
    buildBody(bones, pose.joints, mesh_, BodyPart::LeftLimbs);
    left_.show(mesh_);
    shadow_.show(bones, pose.joints);
    showForce(pose, overlays);
    showContacts(pose);
    showTrails(pose);
}

void Figure::hide() {
    shadow_.hide();
    for (MeshActor* actor : {&body_, &left_, &force_, &contacts_, &trails_})
        actor->hide();
}

void Figure::showForce(const FigurePose& pose, const Overlays& overlays) {
    mesh_.clear();
    if (pose.centreOfMass) {
        const Eigen::Vector3f com = *pose.centreOfMass;
        const Eigen::Vector3f ground(com.x(), kBandHeight, com.z());
        if (overlays.centreOfMass) {
            mesh_.addCapsule(ground, com, 0.004F, 0.004F);
            mesh_.addFloorBand(ground, ground, 0.035F, 0.012F, kBandHeight);
        }
        if (overlays.force && pose.force) {
            mesh_.addArrow(ground, ground + kMetresPerBodyWeight * *pose.force, 0.012F);
        }
    }
    force_.show(mesh_);
}

void Figure::showContacts(const FigurePose& pose) {
    mesh_.clear();
    for (const auto& [heel, toe] : pose.footContacts)
        mesh_.addFloorBand(heel, toe, 0.065F, 0.014F, kBandHeight);
    contacts_.show(mesh_);
}

void Figure::showTrails(const FigurePose& pose) {
    mesh_.clear();
    std::vector<float> radii;
    for (const Trail& trail : pose.trails) {
        radii.clear();
        const auto size = static_cast<int>(trail.path.size());
        for (int i = 0; i < size; ++i) {
            // Thickest where the limb is now, away in both directions.
            const int away = i < trail.now ? trail.now - i : i - trail.now;
            const int whole = std::max(1, i < trail.now ? trail.now : size - 1 - trail.now);
            radii.push_back(0.001F + 0.010F * (1 - static_cast<float>(away) / whole));
        }
        mesh_.addThread(trail.path, radii);
    }
    trails_.show(mesh_);
}

}  // namespace kumite::studio
