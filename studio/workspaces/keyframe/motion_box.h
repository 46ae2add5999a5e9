#pragma once

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

#include "core/editing/assembly.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QSlider;

namespace kumite::studio {

class ActionTiles;
class KeySession;

/// What the keys' motion is made of: the places in the library that are most like the keys, where
/// each part of the body comes from, and how it is put together. Places are shown as small views
/// beside the keys; a click on one takes the body, or the part that is looked for, from there.
class MotionBox : public QWidget {
    Q_OBJECT

public:
    explicit MotionBox(KeySession& keys, QWidget* parent = nullptr);

private:
    void refresh();
    void showTiles();
    void take(int row);
    /// The part that places are like the keys in; nothing: the whole body.
    std::optional<BodyPart> part() const;
    const std::vector<PoseMatch>* found() const;
    bool isTaken(const PoseMatch& match) const;

    KeySession& keys_;
    QLabel* text_;
    QComboBox* scope_;
    ActionTiles* tiles_;
    QListWidget* list_;
    std::array<QComboBox*, kBodyPartCount> parts_;
    QCheckBox* adjusted_;
    QSlider* meet_;
};

}  // namespace kumite::studio
