#pragma once

#include <QDialog>

#include <memory>

#include "core/motion/motion_library.h"

class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;

namespace kumite::studio {

class ActionTiles;
class KeySession;

/// Chooses a pose: a frame of any take or clip of the library, seen in a small view.
class PoseDialog : public QDialog {
    Q_OBJECT

public:
    PoseDialog(KeySession& keys, QWidget* parent);

private:
    const LibraryMotion* motion() const;
    void showMotion();
    void showFrame();
    void take();

    KeySession& keys_;
    std::shared_ptr<const MotionLibrary> library_;
    QComboBox* motions_;
    QSlider* slider_;
    QSpinBox* frame_;
    QLabel* time_;
    ActionTiles* view_;
};

}  // namespace kumite::studio
