#include "studio/app/key_field.h"

#include <QKeyEvent>

namespace kumite::studio {

QKeySequence keyOf(Qt::KeyboardModifiers modifiers, int key, const QString& text) {
    switch (key) {
        case 0:
        case Qt::Key_unknown:
        case Qt::Key_Shift:
        case Qt::Key_Control:
        case Qt::Key_Alt:
        case Qt::Key_AltGr:
        case Qt::Key_Meta:
        case Qt::Key_CapsLock:
        case Qt::Key_NumLock:
            return {};
        default:
            break;
    }
    if (key == Qt::Key_Backtab) key = Qt::Key_Tab;
    // Shift that merely makes the sign belongs to the keyboard, not to the key: "+" is "+".
    const bool sign =
        text.size() == 1 && text[0].isPrint() && !text[0].isLetterOrNumber() && !text[0].isSpace();
    if (sign && modifiers == Qt::ShiftModifier) modifiers = Qt::NoModifier;
    return QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(key)));
}

KeyField::KeyField(QWidget* parent) : QLineEdit(parent) {
    setReadOnly(true);
    setPlaceholderText(tr("Press a key"));
    setAccessibleName(tr("New key"));
    setToolTip(
        tr("Press the key here, alone or with Ctrl, Shift, Alt; then Tab goes on, and "
           "Shift+Tab always goes back"));
}

void KeyField::setKey(const QKeySequence& key) {
    if (key == key_) return;
    key_ = key;
    setText(key.toString(QKeySequence::NativeText));
    Q_EMIT keyChanged();
}

bool KeyField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress) {
        const auto* press = static_cast<QKeyEvent*>(event);
        // The way out for hands without a mouse: back at any time, on once a key is there.
        const bool on = press->key() == Qt::Key_Tab && !key_.isEmpty();
        if (press->key() == Qt::Key_Backtab || on) return QLineEdit::event(event);
        const QKeySequence pressed = keyOf(press->modifiers(), press->key(), press->text());
        if (!pressed.isEmpty()) setKey(pressed);
        event->accept();
        return true;
    }
    return QLineEdit::event(event);
}

}  // namespace kumite::studio
