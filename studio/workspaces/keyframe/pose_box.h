#pragma once

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace kumite::studio {

class KeySession;

/// The chosen key's pose in numbers: where a handle is, whether it stays there while another is
/// drawn, and how the way to the next key goes.
class PoseBox : public QWidget {
    Q_OBJECT

public:
    explicit PoseBox(KeySession& keys, QWidget* parent = nullptr);

private:
    void refresh();
    void addTimes(QFormLayout* form);
    void place(int axis, double metres);

    KeySession& keys_;
    QLabel* text_;
    QComboBox* handle_;
    QCheckBox* pinned_;
    std::array<QDoubleSpinBox*, 3> place_;
    QComboBox* easing_;
    QSpinBox* frame_;
    QCheckBox* along_;
    QDoubleSpinBox* stretch_;
};

}  // namespace kumite::studio
