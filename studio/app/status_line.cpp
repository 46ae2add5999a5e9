#include "studio/app/status_line.h"

namespace kumite::studio {

StatusLine::StatusLine(QWidget* parent) : QLabel(parent) {
    constexpr int kLasts = 8000;  // milliseconds
    setContentsMargins(8, 0, 8, 0);
    setMinimumWidth(1);
    fading_.setSingleShot(true);
    fading_.setInterval(kLasts);
    connect(&fading_, &QTimer::timeout, this, [this] { say({}); });
}

void StatusLine::setKeys(const QString& text) {
    keys_ = text;
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

void StatusLine::refresh() {
    const QString& shown = !said_.isEmpty() ? said_ : !pointer_.isEmpty() ? pointer_ : keys_;
    if (shown != text()) setText(shown);
}

}  // namespace kumite::studio
