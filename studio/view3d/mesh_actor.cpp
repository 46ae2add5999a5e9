#include "studio/view3d/mesh_actor.h"

#include <vtkCamera.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cstring>
#include <numbers>

#include "studio/view3d/camera_controller.h"

namespace kumite::studio {

namespace {

template <typename Array>
void copyInto(Array* array, const std::vector<Eigen::Vector3f>& values) {
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    if (!values.empty()) {
        std::memcpy(array->GetVoidPointer(0), values.data(), values.size() * sizeof(values[0]));
    }
    array->Modified();
}

}  // namespace

void setTriangles(vtkPolyData& data, const std::vector<int>& corners) {
    vtkNew<vtkCellArray> cells;
    const auto count = static_cast<vtkIdType>(corners.size() / 3);
    cells->AllocateExact(count, 3 * count);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const vtkIdType triangle[3] = {corners[i], corners[i + 1], corners[i + 2]};
        cells->InsertNextCell(3, triangle);
    }
    data.SetPolys(cells);
}

void aim(vtkRenderer& renderer, const CameraController& camera, double nearest, double farthest) {
    vtkCamera* vtk = renderer.GetActiveCamera();
    const Eigen::Vector3d position = camera.position();
    const Eigen::Vector3d target = camera.target();
    const Eigen::Vector3d up = camera.up();
    vtk->SetPosition(position.x(), position.y(), position.z());
    vtk->SetFocalPoint(target.x(), target.y(), target.z());
    vtk->SetViewUp(up.x(), up.y(), up.z());
    vtk->SetViewAngle(CameraController::kFieldOfView * 180 / std::numbers::pi);
    vtk->SetClippingRange(nearest, farthest);
}

MeshActor::MeshActor(vtkRenderer* renderer, Surface surface) {
    points_->SetDataTypeToFloat();
    normals_->SetNumberOfComponents(3);
    data_->SetPoints(points_);
    data_->GetPointData()->SetNormals(normals_);
    mapper_->SetInputData(data_);
    mapper_->ScalarVisibilityOff();
    actor_->SetMapper(mapper_);
    actor_->ForceOpaqueOn();
    actor_->VisibilityOff();
    vtkProperty* look = actor_->GetProperty();
    switch (surface) {
        case Surface::Body:
            look->SetAmbient(0.30);
            look->SetDiffuse(0.78);
            look->SetSpecular(0.16);
            look->SetSpecularPower(22);
            break;
        case Surface::Marker:
            look->SetAmbient(0.60);
            look->SetDiffuse(0.50);
            look->SetSpecular(0);
            break;
        case Surface::Flat:
            look->LightingOff();
            break;
    }
    renderer->AddActor(actor_);
}

void MeshActor::setColour(const QColor& colour) {
    actor_->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void MeshActor::setOpacity(double opacity) {
    actor_->GetProperty()->SetOpacity(opacity);
}

void MeshActor::show(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        hide();
        return;
    }
    copyInto(points_->GetData(), mesh.points);
    copyInto(normals_.GetPointer(), mesh.normals);
    points_->Modified();
    const auto count = static_cast<vtkIdType>(mesh.triangles.size() / 3);
    // The triangles of a mesh depend on the number of its corners only.
    if (data_->GetNumberOfPolys() != count) setTriangles(*data_, mesh.triangles);
    data_->Modified();
    actor_->VisibilityOn();
}

}  // namespace kumite::studio
