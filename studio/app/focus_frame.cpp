#include "studio/app/focus_frame.h"

#include <QFocusEvent>

namespace kumite::studio {

FocusFrame::FocusFrame(QWidget* view) : QFrame(view) {
    setProperty("role", "focus");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    view->installEventFilter(this);
    hide();
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event) {
    auto* view = static_cast<QWidget*>(watched);
    switch (event->type()) {
        case QEvent::FocusIn: {
            const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
            if (reason != Qt::TabFocusReason && reason != Qt::BacktabFocusReason) break;
            setGeometry(view->rect());
            raise();
            show();
            break;
        }
        case QEvent::Resize:
            setGeometry(view->rect());
            break;
        case QEvent::FocusOut:
        case QEvent::MouseButtonPress:
            hide();
            break;
        default:
            break;
    }
    return false;
}

}  // namespace kumite::studio
