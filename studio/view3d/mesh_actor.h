#pragma once

#include <QColor>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include "studio/view3d/figure_mesh.h"

class vtkRenderer;

namespace kumite::studio {

class CameraController;

/// Makes triangles of every three corners.
void setTriangles(vtkPolyData& data, const std::vector<int>& corners);
/// Looks at the scene through a camera; what is nearer or farther (metres) is cut off.
void aim(vtkRenderer& renderer, const CameraController& camera, double nearest, double farthest);

/// A mesh in the scene whose corners may move from frame to frame. Actors are drawn in the order
/// in which they were made, also those that let others shine through: VTK's own pass for
/// translucent things costs more than the whole scene where there is no graphics card.
class MeshActor {
public:
    enum class Surface { Body, Marker, Flat };

    MeshActor(vtkRenderer* renderer, Surface surface);

    void setColour(const QColor& colour);
    /// 1 = opaque.
    void setOpacity(double opacity);
    /// Nothing is drawn of an empty mesh.
    void show(const Mesh& mesh);
    void hide() { actor_->VisibilityOff(); }
    vtkPolyDataMapper* mapper() { return mapper_; }

private:
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> normals_;
    vtkNew<vtkPolyData> data_;
    vtkNew<vtkPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

}  // namespace kumite::studio
