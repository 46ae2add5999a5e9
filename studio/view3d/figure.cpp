#include "studio/view3d/figure.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace kumite::studio {

namespace {

vtkNew<vtkPoints> pointsOf(const std::vector<Eigen::Vector3f>& points) {
    vtkNew<vtkPoints> result;
    result->SetDataTypeToFloat();
    result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
    if (!points.empty()) {
        std::memcpy(result->GetVoidPointer(0), points.data(), points.size() * sizeof(points[0]));
    }
    return result;
}

/// Moves the mesh into `data`; the triangles are kept where their number did not change.
void put(const Mesh& mesh, vtkPolyData* data) {
    const vtkNew<vtkPoints> points = pointsOf(mesh.points);
    data->SetPoints(points);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.normals.size()));
    if (!mesh.normals.empty()) {
        std::memcpy(normals->GetVoidPointer(0), mesh.normals.data(),
                    mesh.normals.size() * sizeof(mesh.normals[0]));
    }
    data->GetPointData()->SetNormals(normals);
    const auto count = static_cast<vtkIdType>(mesh.triangles.size() / 3);
    if (data->GetNumberOfPolys() != count) {
        vtkNew<vtkCellArray> cells;
        for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
            const vtkIdType corners[3] = {mesh.triangles[i], mesh.triangles[i + 1],
                                          mesh.triangles[i + 2]};
            cells->InsertNextCell(3, corners);
        }
        data->SetPolys(cells);
    }
    data->Modified();
}

void connect(vtkPolyData* data, vtkActor* actor, vtkRenderer* renderer) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->VisibilityOff();
    renderer->AddActor(actor);
}

void setColour(vtkActor* actor, const QColor& colour) {
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

/// An ellipse on the floor under a set of points: its centre and its two half axes.
struct Ellipse {
    Eigen::Vector2f centre, along, across;
};

Ellipse ellipseUnder(const std::vector<Eigen::Vector3f>& joints) {
    Eigen::Vector2f mean = Eigen::Vector2f::Zero();
    for (const auto& joint : joints)
        mean += Eigen::Vector2f(joint.x(), joint.z());
    mean /= static_cast<float>(joints.size());
    Eigen::Matrix2f spread = Eigen::Matrix2f::Zero();
    for (const auto& joint : joints) {
        const Eigen::Vector2f d = Eigen::Vector2f(joint.x(), joint.z()) - mean;
        spread += d * d.transpose() / static_cast<float>(joints.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2f> axes(spread);
    const auto half = [&](int i) {
        const float size = 0.16F + 1.7F * std::sqrt(std::max(0.0F, axes.eigenvalues()[i]));
        return Eigen::Vector2f(size * axes.eigenvectors().col(i));
    };
    return {mean, half(0), half(1)};
}

}  // namespace

Figure::Figure(vtkRenderer* renderer) {
    connect(shadowData_, blob_, renderer);
    connect(bodyData_, body_, renderer);
    connect(forceData_, force_, renderer);
    body_->GetProperty()->SetAmbient(0.42);
    body_->GetProperty()->SetDiffuse(0.68);
    body_->GetProperty()->SetSpecular(0.12);
    body_->GetProperty()->SetSpecularPower(18);
    force_->GetProperty()->SetAmbient(0.6);
    force_->GetProperty()->SetDiffuse(0.5);
    blob_->GetProperty()->LightingOff();
}

void Figure::setColours(const QColor& body, const QColor& force, double shadow) {
    setColour(body_, body);
    setColour(force_, force);
    shadow_ = shadow;
}

void Figure::show(const std::vector<Bone>& bones, const FigurePose& pose) {
    if (pose.joints.empty()) {
        hide();
        return;
    }
    buildBody(bones, pose.joints, mesh_);
    put(mesh_, bodyData_);
    body_->VisibilityOn();
    showShadow(pose);
    showForce(pose);
}

void Figure::hide() {
    body_->VisibilityOff();
    force_->VisibilityOff();
    blob_->VisibilityOff();
}

void Figure::showForce(const FigurePose& pose) {
    force_->SetVisibility(pose.centreOfMass.has_value());
    if (!pose.centreOfMass) return;
    mesh_.clear();
    const Eigen::Vector3f com = *pose.centreOfMass;
    const Eigen::Vector3f ground(com.x(), -kSole, com.z());
    mesh_.addEllipsoid(com, Eigen::Vector3f::UnitY(), 0.035F, 0.035F);
    mesh_.addEllipsoid(ground, Eigen::Vector3f::UnitY(), 0.004F, 0.05F);
    if (pose.force) {
        const Eigen::Vector3f tip = ground + kMetresPerBodyWeight * *pose.force;
        mesh_.addArrow(ground, tip, 0.011F);
    }
    put(mesh_, forceData_);
}

void Figure::showShadow(const FigurePose& pose) {
    constexpr int kSides = 32;
    constexpr int kRings = 6;
    const Ellipse ellipse = ellipseUnder(pose.joints);
    std::vector<Eigen::Vector3f> corners;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(4);
    for (int ring = 0; ring <= kRings; ++ring) {
        const float radius = static_cast<float>(ring) / kRings;
        const double fade = (1 - radius * radius) * (1 - radius * radius);
        const auto alpha = static_cast<unsigned char>(255 * shadow_ * fade);
        for (int side = 0; side < kSides; ++side) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(side) / kSides;
            const Eigen::Vector2f p = ellipse.centre + radius * (std::cos(angle) * ellipse.along +
                                                                 std::sin(angle) * ellipse.across);
            corners.emplace_back(p.x(), -kSole + 0.003F, p.y());
            colours->InsertNextTuple4(0, 0, 0, alpha);
        }
    }
    if (shadowData_->GetNumberOfPolys() == 0) {
        vtkNew<vtkCellArray> cells;
        for (int ring = 0; ring < kRings; ++ring) {
            for (int side = 0; side < kSides; ++side) {
                const vtkIdType a = ring * kSides + side;
                const vtkIdType b = ring * kSides + (side + 1) % kSides;
                const vtkIdType quad[4] = {a, b, b + kSides, a + kSides};
                cells->InsertNextCell(4, quad);
            }
        }
        shadowData_->SetPolys(cells);
    }
    const vtkNew<vtkPoints> points = pointsOf(corners);
    shadowData_->SetPoints(points);
    shadowData_->GetPointData()->SetScalars(colours);
    blob_->VisibilityOn();
}

}  // namespace kumite::studio
