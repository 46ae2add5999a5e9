#pragma once

#include <QLineEdit>

#include "studio/app/session.h"

namespace kumite::studio {

/// A field that opens on the timeline at an action, to write what is noted about it. Return or
/// leaving it keeps the text (one step of the history), Esc does not.
class NoteField : public QLineEdit {
    Q_OBJECT

public:
    NoteField(Session& session, QWidget* parent);

    /// Opens over `place`, in the parent's coordinates.
    void open(const ActionRef& action, const QRect& place);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void finish(bool keep);

    Session& session_;
    ActionRef action_;
};

}  // namespace kumite::studio
