#pragma once

// What StageView holds; only its own sources include this, so that no other file sees VTK.

#include <QLabel>

#include <array>
#include <vector>

#include "studio/view3d/measuring.h"
#include "studio/view3d/pose.h"
#include "studio/view3d/stage.h"
#include "studio/view3d/stage_labels.h"
#include "studio/view3d/stage_view.h"
#include "studio/view3d/vtk_widget.h"

namespace kumite::studio {

struct StageView::Scene {
    explicit Scene(QWidget* parent)
        : canvas(new VtkWidget(parent)),
          stage(canvas->renderer()),
          labels(new StageLabels(parent)),
          caption(new QLabel(parent)) {}

    VtkWidget* canvas;
    Stage stage;
    StageLabels* labels;
    QLabel* caption;
    CameraController camera;
    std::array<std::vector<Bone>, 2> bones;
    std::array<FigurePose, 2> poses;  ///< as drawn; empty where there is no fighter
    Measuring measuring;
    StageHandles handles;
    StageDrag drag;
};

}  // namespace kumite::studio
