#include "tests/studio/synthetic_bout.h"

#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <QWindow>

#include <cmath>
#include <numbers>
#include <sstream>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/language.h"
#include "studio/app/picture.h"
#include "studio/timeline/timeline_view.h"

namespace kumite::studio {

namespace {

constexpr const char* kSkeleton = R"(HIERARCHY
ROOT Hips { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
 JOINT Chest { OFFSET 0 20 0 CHANNELS 3 Zrotation Xrotation Yrotation
  JOINT Neck { OFFSET 0 28 0 CHANNELS 3 Zrotation Xrotation Yrotation
   JOINT Head { OFFSET 0 10 0 CHANNELS 3 Zrotation Xrotation Yrotation
    End Site { OFFSET 0 18 0 } } }
  JOINT LeftCollar { OFFSET 3 22 0 CHANNELS 3 Zrotation Xrotation Yrotation
   JOINT LeftShoulder { OFFSET 14 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT LeftElbow { OFFSET 28 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
     JOINT LeftWrist { OFFSET 25 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
      End Site { OFFSET 10 0 0 } } } } }
  JOINT RightCollar { OFFSET -3 22 0 CHANNELS 3 Zrotation Xrotation Yrotation
   JOINT RightShoulder { OFFSET -14 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT RightElbow { OFFSET -28 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
     JOINT RightWrist { OFFSET -25 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
      End Site { OFFSET -10 0 0 } } } } } }
 JOINT LeftHip { OFFSET 9 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
  JOINT LeftKnee { OFFSET 0 -43 0 CHANNELS 3 Zrotation Xrotation Yrotation
   JOINT LeftAnkle { OFFSET 0 -42 0 CHANNELS 3 Zrotation Xrotation Yrotation
    End Site { OFFSET 0 -7 14 } } } }
 JOINT RightHip { OFFSET -9 0 0 CHANNELS 3 Zrotation Xrotation Yrotation
  JOINT RightKnee { OFFSET 0 -43 0 CHANNELS 3 Zrotation Xrotation Yrotation
   JOINT RightAnkle { OFFSET 0 -42 0 CHANNELS 3 Zrotation Xrotation Yrotation
    End Site { OFFSET 0 -7 14 } } } }
}
)";

constexpr int kJoints = 18;
constexpr int kLeftShoulder = 5;
constexpr int kRightShoulder = 9;

void writeFile(const QString& path, const std::string& text) {
    QFile out(path);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(text.data(), static_cast<qint64>(text.size()));
}

}  // namespace

std::string bobbingPerson(double phase, double x, int frames, double rate) {
    std::ostringstream out;
    out << kSkeleton << "MOTION\nFrames: " << frames << "\nFrame Time: " << 1 / rate << "\n";
    for (int frame = 0; frame < frames; ++frame) {
        const double t = 2 * std::numbers::pi * frame / rate;
        const double height =
            92 + 4 * std::sin(1.1 * t + phase) + 1.2 * std::sin(2.3 * t + 2 * phase);
        out << x << ' ' << height << ' ' << 3 * std::sin(0.4 * t) << " 0 0 "
            << 8 * std::sin(0.3 * t);
        for (int joint = 1; joint < kJoints; ++joint) {
            double roll = 0;
            if (joint == kLeftShoulder) roll = -70 + 15 * std::sin(0.7 * t + phase);
            if (joint == kRightShoulder) roll = 70 + 15 * std::sin(0.7 * t);
            out << ' ' << roll << " 0 0";
        }
        out << '\n';
    }
    return out.str();
}

void WindowTest::SetUp() {
    // What a test before chose, such as more rows on the timeline, is of no concern.
    QSettings().clear();
    writeFile(file("left.bvh"), bobbingPerson(0.0, 0));
    writeFile(file("right.bvh"), bobbingPerson(1.3, 120));
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 800);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());
}

void WindowTest::TearDown() {
    window_.reset();
}

void WindowTest::settle() {
    QTest::qWait(10);
    waitWhileBusy(*window_);
    QTest::qWait(30);
}

void WindowTest::openBout() {
    window_->files().open(recordings());
    settle();
    ASSERT_TRUE(session().document().isOpen()) << window_->windowTitle().toStdString();
    ASSERT_NE(session().fighter(0), nullptr);
    ASSERT_NE(session().fighter(1), nullptr);
}

BoundaryRef WindowTest::someBoundary(int player) {
    const auto& marks = session().marks(player);
    for (std::size_t i = 2; i + 2 < marks.size(); ++i) {
        const bool alone =
            marks[i].frame - marks[i - 1].frame > 20 && marks[i + 1].frame - marks[i].frame > 20;
        if (alone && marks[i].state == MarkState::Detected) return {player, marks[i].frame};
    }
    ADD_FAILURE() << "no boundary stands alone among " << marks.size();
    return {player, 0};
}

const BoundaryMark* WindowTest::mark(const BoundaryRef& boundary) {
    return nearestMark(session().marks(boundary.player), boundary.frame, 0.5);
}

void WindowTest::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(&timeline(), key, modifiers);
}

void WindowTest::click(const QPointF& position) {
    QTest::mouseClick(&timeline(), Qt::LeftButton, Qt::NoModifier, position.toPoint());
}

void WindowTest::hover(QWidget& widget, const QPoint& position) {
    QTest::mouseMove(widget.window()->windowHandle(), widget.mapTo(widget.window(), position));
}

void answer(const QString& text, int patience) {
    QTimer::singleShot(25, qApp, [text, patience] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box == nullptr) {
            ASSERT_GT(patience, 0) << "nothing was asked that " << text.toStdString() << " answers";
            return answer(text, patience - 1);
        }
        for (QAbstractButton* button : box->buttons()) {
            if (withoutMnemonic(button->text()) == text) return button->click();
        }
        ADD_FAILURE() << "no button " << text.toStdString();
        box->reject();
    });
}

}  // namespace kumite::studio
