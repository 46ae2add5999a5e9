#pragma once

#include <QWidget>

#include <vector>

#include "core/transition/transition_synthesis.h"

namespace kumite::studio {

/// How far poses are from each other where two motions are joined: the last frames of what was
/// there down, the first frames of what comes in to the right; dark is near, a ring marks where
/// they were joined. One picture a join.
class DistanceGridView : public QWidget {
    Q_OBJECT

public:
    explicit DistanceGridView(QWidget* parent = nullptr);

    void show(std::vector<DistanceGrid> grids);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<DistanceGrid> grids_;
};

}  // namespace kumite::studio
