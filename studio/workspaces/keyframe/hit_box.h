#pragma once

#include <QWidget>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace kumite::studio {

class HitSession;

/// The hit tool in numbers: which strike, where the target is, and how well it is hit.
class HitBox : public QWidget {
    Q_OBJECT

public:
    explicit HitBox(HitSession& hit, QWidget* parent = nullptr);

private:
    void refresh();

    HitSession& hit_;
    QComboBox* strike_;
    QComboBox* aim_;
    QDoubleSpinBox* distance_;
    std::array<QDoubleSpinBox*, 3> place_;
    QLabel* text_;
};

}  // namespace kumite::studio
