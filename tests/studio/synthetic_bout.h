#pragma once

#include <gtest/gtest.h>

#include <QStringList>
#include <QTemporaryDir>

#include <memory>

#include "studio/app/main_window.h"

namespace kumite::studio {

/// BVH text of a person of 19 joints (Biovision names, centimetres) who bobs on the spot, so that
/// the contact force has minima. `phase` shifts the bobbing, `x` the place.
std::string bobbingPerson(double phase, double x, int frames = 600, double rate = 60);

/// Presses a button, by its text, of the message box that comes up next.
void answer(const QString& text, int patience = 400);

/// A real window in a folder of its own, and two recordings in it.
class WindowTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    QString file(const QString& name) const { return folder_.filePath(name); }
    QStringList recordings() const { return {file("left.bvh"), file("right.bvh")}; }

    /// Lets the window work until it is idle.
    void settle();
    void openBout();
    Session& session() { return window_->session(); }
    TimelineView& timeline() { return window_->timeline(); }
    /// A boundary of a player in the middle of the take that is detected and far from others.
    BoundaryRef someBoundary(int player);
    const BoundaryMark* mark(const BoundaryRef& boundary);
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void click(const QPointF& position);
    /// Rests the pointer on a widget. The window is told so itself: a move of the real pointer
    /// (what QTest does for widgets) comes by way of the X server, at its own time.
    void hover(QWidget& widget, const QPoint& position);

    QTemporaryDir folder_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace kumite::studio
