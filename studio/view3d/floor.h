#pragma once

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <Eigen/Core>

#include "studio/app/theme.h"
#include "studio/view3d/camera_controller.h"

class vtkRenderer;

namespace kumite::studio {

/// The floor: a grid of 1 m with fine lines every 0.5 m that fades with distance, and metres
/// written along the axes x and z through the origin of the bout's space.
class Floor {
public:
    explicit Floor(vtkRenderer* renderer);

    void setColours(const Colours& colours);
    /// The floor reaches at least over this box.
    void cover(const Box& box);
    /// From its middle to where it has faded, metres.
    double radius() const { return radius_; }

private:
    void draw();
    void drawLines();
    void drawNumbers();

    const Colours* colours_ = nullptr;
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
    double radius_ = 5;
    vtkNew<vtkPolyData> lines_;
    vtkNew<vtkActor> lineActor_;
    vtkNew<vtkImageData> digits_;
    vtkNew<vtkPolyData> numbers_;
    vtkNew<vtkActor> numberActor_;
};

}  // namespace kumite::studio
