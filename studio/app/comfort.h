#pragma once

#include <QSize>

class QWidget;

namespace kumite::studio {

/// How large text is, percent of the platform's, 100 to 200. The whole application follows at the
/// next `applyTheme`.
void setTextSize(int percent);
int textSize();
/// A length in pixels that goes along with the size of text.
int withTextSize(int pixels);
double withTextSize(double pixels);
/// The size of a dialog that was made for text of 100 %: larger with the text, as far as the screen
/// that it comes up on has room.
QSize roomFor(const QWidget& dialog, QSize size);
/// Brings widths, heights, rows and icons that were given in pixels, below a widget, to another
/// size of text.
void rescale(QWidget& root, double ratio);

/// Whether nothing shall move by itself: what would begin to play waits for a key.
void setMotionReduced(bool reduced);
bool isMotionReduced();

}  // namespace kumite::studio
