#include "studio/view3d/stage.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
    : renderer_(renderer), figures_{Figure(renderer), Figure(renderer)} {
    renderer_->SetAutomaticLightCreation(false);
    renderer_->SetGradientBackground(true);
    setSmooth(true);
    addLight(renderer_, 0.4, 0.9, 1.0, 0.75);
    addLight(renderer_, -0.9, 0.3, 0.8, 0.45);
    addLight(renderer_, 0.3, 0.4, -1.0, 0.20);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(floorData_);
    floor_->SetMapper(mapper);
    floor_->GetProperty()->LightingOff();
    renderer_->AddActor(floor_);
}

void Stage::setColours(const Colours& colours, int active) {
    const bool floorChanged = colours_ != &colours;
    colours_ = &colours;
    const QColor low = colours.ground;
    const QColor high = colours.dark ? colours.ground.lighter(118) : QColor("#ffffff");
    renderer_->SetBackground(low.redF(), low.greenF(), low.blueF());
    renderer_->SetBackground2(high.redF(), high.greenF(), high.blueF());
    for (int player = 0; player < 2; ++player) {
        const QColor plain = colours.fighters[player];
        const double away = active < 0 || player == active ? 0.0 : colours.dark ? 0.20 : 0.12;
        const QColor body = mixed(plain, colours.ground, away);
        const QColor force = mixed(plain, colours.text, 0.45);
        figure(player).setColours(body, force, colours.dark ? 0.55 : 0.28);
    }
    if (floorChanged) drawFloor();
}

void Stage::setSmooth(bool smooth) {
    // A fraction of the cost of multisampling.
    renderer_->SetUseFXAA(smooth);
}

void Stage::setFloor(const Box& box) {
    if (box.empty()) return;
    const Eigen::Vector3d centre = box.centre();
    floorCentre_ = {std::round(centre.x()), std::round(centre.z())};
    const Eigen::Vector3d size = box.high - box.low;
    floorRadius_ = std::clamp(0.5 * std::hypot(size.x(), size.z()) + 3.0, 5.0, 60.0);
    drawFloor();
}

void Stage::drawFloor() {
    if (colours_ == nullptr) return;
    constexpr double kStep = 0.5;
    const int reach = static_cast<int>(std::ceil(floorRadius_ / kStep));
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkUnsignedCharArray> shades;
    shades->SetNumberOfComponents(4);
    const QColor strong = mixed(colours_->line, colours_->secondText, 0.45);
    const auto put = [&](double x, double z, double weight) {
        const double away = std::hypot(x - floorCentre_.x(), z - floorCentre_.y()) / floorRadius_;
        const double fade = std::max(0.0, 1 - away * away);
        points->InsertNextPoint(x, -Figure::kSole, z);
        shades->InsertNextTuple4(strong.red(), strong.green(), strong.blue(), 255 * weight * fade);
    };
    for (int line = -reach; line <= reach; ++line) {
        const double weight = line % 2 == 0 ? 0.9 : 0.3;
        for (const bool alongX : {true, false}) {
            vtkIdType previous = -1;
            for (int at = -reach; at <= reach; ++at) {
                const double x = floorCentre_.x() + kStep * (alongX ? at : line);
                const double z = floorCentre_.y() + kStep * (alongX ? line : at);
                put(x, z, weight);
                const vtkIdType corner = points->GetNumberOfPoints() - 1;
                if (previous >= 0) {
                    const vtkIdType ends[2] = {previous, corner};
                    lines->InsertNextCell(2, ends);
                }
                previous = corner;
            }
        }
    }
    floorData_->SetPoints(points);
    floorData_->SetLines(lines);
    floorData_->GetPointData()->SetScalars(shades);
}

void Stage::setCamera(const CameraController& camera) {
    vtkCamera* vtk = renderer_->GetActiveCamera();
    const Eigen::Vector3d position = camera.position();
    const Eigen::Vector3d target = camera.target();
    const Eigen::Vector3d up = camera.up();
    vtk->SetPosition(position.x(), position.y(), position.z());
    vtk->SetFocalPoint(target.x(), target.y(), target.z());
    vtk->SetViewUp(up.x(), up.y(), up.z());
    vtk->SetViewAngle(CameraController::kFieldOfView * 180 / std::numbers::pi);
    vtk->SetClippingRange(0.02 * camera.distance(), camera.distance() + 2 * floorRadius_ + 20);
}

}  // namespace kumite::studio
