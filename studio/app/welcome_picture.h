#pragma once

#include <QWidget>

namespace kumite::studio {

/// What the studio is for in one drawing: two fighters, the force that each exerts against the
/// ground, its minima, and the actions that these cut the bout into.
class WelcomePicture : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePicture(QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace kumite::studio
