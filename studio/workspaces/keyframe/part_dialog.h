#pragma once

#include <QDialog>

#include <memory>

#include "core/editing/part_edit.h"
#include "core/motion/motion_library.h"
#include "studio/workspaces/made_motion.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace kumite::studio {

class ActionTiles;
class KeySession;

/// One part of a take replaced over a range of frames by that of another take or clip: the take,
/// where the part comes from and the result as small views that loop in step. The result is kept as
/// a take.
class PartDialog : public QDialog {
    Q_OBJECT

public:
    PartDialog(KeySession& keys, QWidget* parent);

    /// Null where the frames that are named do not exist.
    std::shared_ptr<const Clip> result() const { return result_; }
    MadeMotion madeMotion() const;

private:
    /// Take or clip and a range of its frames.
    struct Stretch {
        QComboBox* motion;
        QSpinBox* begin;
        QSpinBox* end;
    };
    Stretch addStretch(QFormLayout* form, const QString& title, const QString& name);
    const LibraryMotion& motionOf(const Stretch& stretch) const;
    void limit(const Stretch& stretch);
    void chooseUsual();
    void edit();

    KeySession& keys_;
    std::shared_ptr<const MotionLibrary> library_;
    Stretch take_, source_;
    QComboBox* part_;
    QCheckBox* adjusted_;
    ActionTiles* views_;
    QLabel* text_;
    QPushButton* keep_;
    std::shared_ptr<const Clip> result_;
};

}  // namespace kumite::studio
