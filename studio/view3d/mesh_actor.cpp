#include "studio/view3d/mesh_actor.h"

#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cstring>

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
    if (data_->GetNumberOfPolys() != count) {
        vtkNew<vtkCellArray> cells;
        cells->AllocateExact(count, 3 * count);
        for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
            const vtkIdType corners[3] = {mesh.triangles[i], mesh.triangles[i + 1],
                                          mesh.triangles[i + 2]};
            cells->InsertNextCell(3, corners);
        }
        data_->SetPolys(cells);
    }
    data_->Modified();
    actor_->VisibilityOn();
}

}  // namespace kumite::studio
