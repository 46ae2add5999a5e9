#pragma once

#include <QWidget>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace kumite::studio {

class KeySession;

/// One joint of the chosen key's pose in degrees, and how much of its limits that takes. The chosen
/// joint has rings in the 3D view.
class JointBox : public QWidget {
    Q_OBJECT

public:
    explicit JointBox(KeySession& keys, QWidget* parent = nullptr);

private:
    void fill();
    void refresh();
    void turn();

    KeySession& keys_;
    QComboBox* joint_;
    std::array<QDoubleSpinBox*, 3> angles_;
    QLabel* limits_;
    const void* filledFor_ = nullptr;  ///< the rig whose joints are offered
};

}  // namespace kumite::studio
