#pragma once

#include <QColor>

#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <Eigen/Core>

#include "studio/view3d/figure_mesh.h"

class vtkRenderer;

namespace kumite::studio {

/// What is drawn of a fighter at one moment, in the bout's space: metres, y up, floor at 0.
struct FigurePose {
    std::vector<Eigen::Vector3f> joints;
    std::optional<Eigen::Vector3f> centreOfMass;
    std::optional<Eigen::Vector3f> force;  ///< contact force, body weights
};

/// A fighter in the scene: body, soft shadow, centre of mass and contact force.
class Figure {
public:
    /// Metres that the arrow of one body weight is long.
    static constexpr float kMetresPerBodyWeight = 0.5F;
    /// Half the thickness of a foot: how far below the toe joints the soles, and so the drawn
    /// floor, lie.
    static constexpr float kSole = 0.028F;

    explicit Figure(vtkRenderer* renderer);

    void setColours(const QColor& body, const QColor& force, double shadow);
    void show(const std::vector<Bone>& bones, const FigurePose& pose);
    void hide();

private:
    void showForce(const FigurePose& pose);
    void showShadow(const FigurePose& pose);

    Mesh mesh_;
    double shadow_ = 0.4;
    vtkNew<vtkPolyData> bodyData_;
    vtkNew<vtkPolyData> forceData_;
    vtkNew<vtkPolyData> shadowData_;
    vtkNew<vtkActor> body_;
    vtkNew<vtkActor> force_;
    vtkNew<vtkActor> blob_;
};

}  // namespace kumite::studio
