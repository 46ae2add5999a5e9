#include "studio/app/status_line.h"

#include <QEvent>

namespace kumite::studio {

StatusLine::StatusLine(QWidget* parent) : QLabel(parent) {
    constexpr int kLasts = 8000;  // milliseconds
    setContentsMargins(8, 0, 8, 0);
    setMinimumWidth(1);
    fading_.setSingleShot(true);
    fading_.setInterval(kLasts);
    connect(&fading_, &QTimer::timeout, this, [this] { say({}); });
}

void StatusLine::setKeys(const QStringList& parts) {
    keys_ = parts;
    refresh();
}

void StatusLine::setPointer(const QString& text) {
    pointer_ = text;
    refresh();
}

void StatusLine::say(const QString& sentence) {
    said_ = sentence;
    if (said_.isEmpty()) {
        fading_.stop();
    } else {
        fading_.start();
    }
    refresh();
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    refresh();
}

void StatusLine::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange) refresh();
}

void StatusLine::refresh() {
    QString shown = !said_.isEmpty() ? said_ : !pointer_.isEmpty() ? pointer_ : fittingKeys();
    // The whole sentence is the tip where it does not fit.
    const QString fitting = fontMetrics().elidedText(shown, Qt::ElideRight, contentsRect().width());
    setToolTip(fitting == shown ? QString() : shown);
    if (fitting != text()) setText(fitting);
}

QString StatusLine::fittingKeys() const {
    QStringList parts = keys_;
    const auto whole = [&parts] { return parts.join(QStringLiteral("   ")); };
    while (parts.size() > 1 && fontMetrics().horizontalAdvance(whole()) > contentsRect().width())
        parts.removeAt(parts.size() - 2);
    return whole();
}

}  // namespace kumite::studio
