#include "studio/timeline/note_field.h"

#include <QKeyEvent>

namespace kumite::studio {

NoteField::NoteField(Session& session, QWidget* parent) : QLineEdit(parent), session_(session) {
    setAccessibleName(tr("Note on the action"));
    setToolTip(tr("Return keeps the note, Esc leaves it as it was; no text removes it."));
    setPlaceholderText(tr("Note on this action"));
    setMaxLength(500);
    hide();
    connect(this, &QLineEdit::returnPressed, this, [this] { finish(true); });
    // Another take has other actions.
    connect(&session_, &Session::takeChanged, this, [this] { finish(false); });
}

void NoteField::open(const ActionRef& action, const QRect& place) {
    action_ = action;
    setText(session_.noteOf(action));
    selectAll();
    setGeometry(place);
    show();
    raise();
    setFocus();
}

bool NoteField::event(QEvent* event) {
    // Return is a key of the review around it.
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    return QLineEdit::event(event);
}

void NoteField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        finish(false);
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void NoteField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) {
        finish(true);
    }
}

void NoteField::finish(bool keep) {
    if (isHidden()) return;
    hide();
    if (keep) session_.setNote(action_, text());
    parentWidget()->setFocus();
}

}  // namespace kumite::studio
