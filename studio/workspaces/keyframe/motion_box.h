#pragma once

#include <QWidget>

#include <array>

#include "core/editing/body_parts.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QSlider;

namespace kumite::studio {

class KeySession;

/// What the keys' motion is made of: the places in the library that are most like the keys, where
/// each part of the body comes from, and how it is put together. A click on a place takes it.
class MotionBox : public QWidget {
    Q_OBJECT

public:
    explicit MotionBox(KeySession& keys, QWidget* parent = nullptr);

private:
    void refresh();
    void take(int row);

    KeySession& keys_;
    QLabel* text_;
    QListWidget* list_;
    std::array<QComboBox*, kBodyPartCount> parts_;
    QCheckBox* adjusted_;
    QSlider* meet_;
};

}  // namespace kumite::studio
