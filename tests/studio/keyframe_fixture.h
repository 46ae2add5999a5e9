#pragma once

#include <QTabWidget>
#include <QTest>

#include <vector>

#include "studio/app/workspaces.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/keyframe/key_panel.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/key_strip.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {

/// The Keyframe workspace of two made fighters in the real window.
class KeyframeTest : public WindowTest {
protected:
    void openWorkspace() {
        openBout();
        window_->workspaces().show("keyframe");
        settle();
        ASSERT_NE(keys().library(), nullptr) << keys().whyNothing().toStdString();
    }
    /// Keys at 0, 30 and 60 by Return.
    void makeKeys() {
        window_->stage().setFocus();
        for (const int frame : {0, 30, 60}) {
            keys().seek(frame);
            press(Qt::Key_Return);
            settle();
        }
    }
    QTabWidget& tabs() { return *window_->findChild<KeyPanel*>()->findChild<QTabWidget*>(); }
    KeySession& keys() { return window_->keys(); }
    KeyStrip& strip() { return *window_->findChild<KeyStrip*>(); }
    std::vector<int> frames() {
        std::vector<int> all;
        for (const KeyPose& key : keys().draft().track.keys)
            all.push_back(key.frame);
        return all;
    }
    Eigen::Vector3d placeOf(Handle handle) {
        return *handlePoint(*keys().draft().track.rig, *keys().pose(), handle);
    }
    /// Drags a handle of the figure by pixels.
    void dragHandle(Handle handle, const QPoint& way) {
        const auto index = static_cast<int>(handle);
        const auto at = window_->stage().handlePosition(index);
        ASSERT_TRUE(at);
        const QPoint from = at->toPoint();
        QTest::mousePress(&window_->stage(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&window_->stage(), from + way / 2);
        QTest::mouseMove(&window_->stage(), from + way);
        QTest::mouseRelease(&window_->stage(), Qt::LeftButton, {}, from + way);
        settle();
    }
};

}  // namespace kumite::studio
