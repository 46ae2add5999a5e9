#include "studio/app/control_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QTabBar>

namespace kumite::studio {

namespace {

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool leads(int key) {
    return isArrow(key) || key == Qt::Key_Home || key == Qt::Key_End || key == Qt::Key_PageUp ||
           key == Qt::Key_PageDown;
}

}  // namespace

bool worksControl(const QWidget& focused, const QKeyEvent& key) {
    const auto is = [&focused](auto* kind) {
        return qobject_cast<decltype(kind)>(&focused) != nullptr;
    };
    const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeypadModifier;
    if (is(static_cast<const QAbstractButton*>(nullptr))) {
        return key.key() == Qt::Key_Space && held == Qt::NoModifier;
    }
    const bool choices = is(static_cast<const QComboBox*>(nullptr));
    const bool opens = key.key() == Qt::Key_Up || key.key() == Qt::Key_Down;
    if (choices && held == Qt::AltModifier && opens) return true;
    if (choices && held == Qt::NoModifier && key.key() == Qt::Key_Space) return true;
    if (!leads(key.key()) || (held & ~Qt::ShiftModifier)) return false;
    return choices || is(static_cast<const QAbstractSlider*>(nullptr)) ||
           is(static_cast<const QAbstractItemView*>(nullptr)) ||
           is(static_cast<const QTabBar*>(nullptr)) ||
           is(static_cast<const QAbstractSpinBox*>(nullptr));
}

}  // namespace kumite::studio
