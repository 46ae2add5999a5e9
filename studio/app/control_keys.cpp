#include "studio/app/control_keys.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QTabBar>
#include <QTableView>

namespace kumite::studio {

namespace {

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool leads(int key) {
    return isArrow(key) || key == Qt::Key_Home || key == Qt::Key_End || key == Qt::Key_PageUp ||
           key == Qt::Key_PageDown;
}

bool confirms(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

template <typename Kind>
bool is(const QWidget& widget) {
    return qobject_cast<const Kind*>(&widget) != nullptr;
}

/// Lists, and tables of which rows are chosen: ← and → lead nowhere in them.
bool hasRowsAlone(const QWidget& widget) {
    const auto* table = qobject_cast<const QTableView*>(&widget);
    return is<QListView>(widget) ||
           (table != nullptr && table->selectionBehavior() == QAbstractItemView::SelectRows);
}

}  // namespace

bool worksControl(const QWidget& focused, const QKeyEvent& key) {
    const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeypadModifier;
    if (is<QAbstractButton>(focused))
        return (key.key() == Qt::Key_Space || confirms(key.key())) && held == Qt::NoModifier;
    const bool choices = is<QComboBox>(focused);
    const bool opens = key.key() == Qt::Key_Up || key.key() == Qt::Key_Down;
    if (choices && held == Qt::AltModifier && opens) return true;
    if (choices && held == Qt::NoModifier && key.key() == Qt::Key_Space) return true;
    if (!leads(key.key()) || (held & ~Qt::ShiftModifier)) return false;
    const bool sideways = key.key() == Qt::Key_Left || key.key() == Qt::Key_Right;
    if (sideways && hasRowsAlone(focused)) return false;
    return choices || is<QAbstractSlider>(focused) || is<QAbstractItemView>(focused) ||
           is<QTabBar>(focused) || is<QAbstractSpinBox>(focused);
}

bool isControl(const QWidget& widget) {
    return is<QAbstractButton>(widget) || is<QAbstractScrollArea>(widget) ||
           is<QAbstractSlider>(widget) || is<QAbstractSpinBox>(widget) || is<QComboBox>(widget) ||
           is<QLineEdit>(widget) || is<QMenuBar>(widget) || is<QTabBar>(widget);
}

bool pressesButton(QObject* focused, const QKeyEvent& key) {
    auto* button = qobject_cast<QAbstractButton*>(focused);
    const Qt::KeyboardModifiers held = key.modifiers() & ~Qt::KeypadModifier;
    // Dialogs have a way of their own with these keys.
    if (button == nullptr || !confirms(key.key()) || held != Qt::NoModifier || key.isAutoRepeat() ||
        qobject_cast<QDialog*>(button->window()) != nullptr)
        return false;
    button->click();
    return true;
}

}  // namespace kumite::studio
