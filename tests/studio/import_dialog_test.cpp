// The import dialog, driven by mouse and keys.

#include "studio/app/import/import_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>

#include <numbers>

#include "studio/app/import/import_preview.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

class ImportTest : public WindowTest {
protected:
    ImportDialog& openDialog(const QStringList& files, const QString& project = {}) {
        dialog_ = std::make_unique<ImportDialog>(files, project, window_.get());
        dialog_->show();
        dialog_->activateWindow();
        wait();
        return *dialog_;
    }
    void TearDown() override {
        dialog_.reset();
        WindowTest::TearDown();
    }
    void wait() {
        QTest::qWait(20);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog_->isBusy(), 30000);
        QTest::qWait(20);
    }
    template <typename Widget>
    Widget* named(const QString& name) {
        for (auto* each : dialog_->findChildren<Widget*>()) {
            if (each->accessibleName() == name) return each;
        }
        ADD_FAILURE() << name.toStdString();
        return nullptr;
    }
    QPushButton* button(const QString& text) {
        for (auto* each : dialog_->findChildren<QPushButton*>()) {
            if (each->text() == text) return each;
        }
        ADD_FAILURE() << text.toStdString();
        return nullptr;
    }
    void type(const QString& name, const QString& text) {
        auto* field = named<QLineEdit>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    QString findings() { return dialog_->findChild<QLabel*>("findings")->text(); }
    void pressOpen() { QTest::mouseClick(button("Open bout"), Qt::LeftButton); }

    std::unique_ptr<ImportDialog> dialog_;
};

TEST_F(ImportTest, LeavesToBeFoundWhatIsLeftBlankAndShowsWhatWasFound) {
    ImportDialog& dialog = openDialog(recordings());
    EXPECT_EQ(named<QComboBox>("Unit of length of fighter 1")->currentText(), "cm (found)");
    EXPECT_EQ(named<QComboBox>("Up axis of fighter 2")->currentText(), "y (found)");
    pressOpen();
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    const TakeRequest request = dialog.request();
    ASSERT_EQ(request.fighters.size(), 2U);
    EXPECT_EQ(request.fighters[1].path, file("right.bvh").toStdString());
    EXPECT_FALSE(request.rate.has_value());
    EXPECT_FALSE(request.trim.has_value());
    EXPECT_FALSE(request.fighters[0].metresPerUnit.has_value());
    EXPECT_EQ(dialog.recordings().size(), 2U) << "they are not read a second time";
    EXPECT_FALSE(dialog.addsToProject());
}

TEST_F(ImportTest, TakesWhatTheUserSaysByKeys) {
    ImportDialog& dialog = openDialog(recordings(), "bout.kumite");
    type("Take name", "round 1");
    type("Rate in Hz", "59.94");
    type("Frames, begin:end", "120:");
    type("Start of fighter 2", "0.25");
    type("Place x of fighter 2", "1.5");
    type("Turn of fighter 2", "180");
    type("Floor of fighter 1", "0.02");
    auto* units = named<QComboBox>("Unit of length of fighter 1");
    units->setFocus();
    QTest::keyClicks(units, "inch");
    wait();
    QTest::keyClick(&dialog, Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    const TakeRequest request = dialog.request();
    EXPECT_EQ(request.name, "round 1");
    EXPECT_DOUBLE_EQ(request.rate.value(), 59.94);
    EXPECT_EQ(request.trim.value(), (FrameRange{120, -1}));
    EXPECT_DOUBLE_EQ(request.fighters[1].offset, 0.25);
    EXPECT_DOUBLE_EQ(request.fighters[1].placement.x, 1.5);
    EXPECT_NEAR(request.fighters[1].placement.yaw, std::numbers::pi, 1e-12);
    EXPECT_DOUBLE_EQ(request.fighters[0].floor.value(), 0.02);
    EXPECT_NEAR(request.fighters[0].metresPerUnit.value(), 0.0254, 1e-12);
    EXPECT_FALSE(request.fighters[1].metresPerUnit.has_value()) << "each file has its own";
    EXPECT_TRUE(dialog.addsToProject());
}

TEST_F(ImportTest, SwapExchangesTheFightersWithAllThatIsSaidOfThem) {
    ImportDialog& dialog = openDialog(recordings());
    type("Place x of fighter 2", "1.5");
    wait();
    QTest::mouseClick(named<QPushButton>("Swap fighters"), Qt::LeftButton);
    wait();
    pressOpen();
    const TakeRequest request = dialog.request();
    EXPECT_EQ(request.fighters[0].path, file("right.bvh").toStdString());
    EXPECT_EQ(request.fighters[1].path, file("left.bvh").toStdString());
    EXPECT_DOUBLE_EQ(request.fighters[0].placement.x, 1.5);
    EXPECT_DOUBLE_EQ(request.fighters[1].placement.x, 0);
}

TEST_F(ImportTest, ARoleIsMendedInTheTable) {
    ImportDialog& dialog = openDialog(recordings());
    dialog.findChild<QTabWidget*>()->setCurrentIndex(1);
    auto* head = named<QComboBox>("head of fighter 1");
    EXPECT_EQ(head->currentText(), "Head");
    head->setFocus();
    QTest::keyClick(head, Qt::Key_Home);  // none
    wait();
    EXPECT_EQ(head->currentText(), "none");
    EXPECT_TRUE(dialog.findChild<QTabWidget*>()->tabText(1).contains("1 missing"));
    pressOpen();
    const auto roles = dialog.request().fighters[0].roles;
    ASSERT_EQ(roles.size(), 1U);
    EXPECT_EQ(roles[0].first, Role::Head);
    EXPECT_TRUE(roles[0].second.empty());
}

TEST_F(ImportTest, SaysWhatIsWrongAndStays) {
    openDialog(recordings());
    for (const auto& [name, text] : {std::pair("Rate in Hz", "fast"),
                                     {"Rate in Hz", "-60"},
                                     {"Frames, begin:end", "900:120"},
                                     {"Frames, begin:end", "5"},
                                     {"Frames, begin:end", "5000:"},
                                     {"Start of fighter 2", "1,5"}}) {
        type(name, text);
        wait();
        EXPECT_FALSE(findings().isEmpty()) << text;
        EXPECT_FALSE(button("Open bout")->isEnabled()) << text;
        QTest::keyClick(dialog_.get(), Qt::Key_Return);
        EXPECT_TRUE(dialog_->isVisible()) << text;
        named<QLineEdit>(name)->clear();
        wait();
        EXPECT_TRUE(button("Open bout")->isEnabled()) << text;
    }
}

TEST_F(ImportTest, AFormatThatIsNotReadNamesTheWayThroughBlender) {
    QFile fbx(file("bout.fbx"));
    ASSERT_TRUE(fbx.open(QIODevice::WriteOnly));
    fbx.write("Kaydara FBX Binary  ");
    fbx.close();
    openDialog({file("bout.fbx")});
    EXPECT_TRUE(findings().contains("Blender")) << findings().toStdString();
    EXPECT_FALSE(button("Open bout")->isEnabled());
}

TEST_F(ImportTest, WhichSkeletonOfAFileCanBeChosen) {
    QFile two(file("two.bvh"));
    ASSERT_TRUE(two.open(QIODevice::WriteOnly));
    two.write(
        "HIERARCHY\nROOT A { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition End Site "
        "{ OFFSET 0 1 0 } }\nROOT B { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition "
        "End Site { OFFSET 0 1 0 } }\nMOTION\nFrames: 3\nFrame Time: 0.01\n"
        "0 0 0 1 1 1\n0 0 0 1 1 1\n0 0 0 1 1 1\n");
    two.close();
    ImportDialog& dialog = openDialog({file("two.bvh")});
    auto* root = named<QComboBox>("Skeleton of fighter 1");
    ASSERT_TRUE(root->isVisible());
    root->setFocus();
    QTest::keyClick(root, Qt::Key_Down);
    wait();
    pressOpen();
    EXPECT_EQ(dialog.request().fighters[0].root, "B");
}

TEST_F(ImportTest, PreviewPlaysStepsAndScrubs) {
    ImportDialog& dialog = openDialog(recordings());
    auto* preview = dialog.findChild<ImportPreview*>();
    preview->setFocus();
    QTest::keyClick(preview, Qt::Key_Right);
    EXPECT_NEAR(preview->seconds(), 1 / 60.0, 1e-9);
    QTest::keyClick(preview, Qt::Key_Space);
    EXPECT_TRUE(preview->isPlaying());
    QTRY_VERIFY(preview->seconds() > 0.1);
    QTest::mouseClick(button("&Pause"), Qt::LeftButton);
    EXPECT_FALSE(preview->isPlaying());
    QTest::mouseClick(preview, Qt::LeftButton, Qt::NoModifier,
                      QPoint(preview->width() - 13, preview->height() - 50));
    EXPECT_GT(preview->seconds(), 9.8);
    preview->grab();
}

TEST_F(ImportTest, LookGivesDistanceAndPlace) {
    TakeRequest request = requestFor(recordings());
    request.fighters[1].placement.x = 1;
    const auto known = readRecordings(recordingsOf(request));
    const ImportLook look = lookAt(request, known, {});
    // The files stand 1.2 m apart.
    EXPECT_NEAR(look.distanceAt(3.0), 2.2, 1e-3);
    EXPECT_NEAR(look.span.end, 599 / 60.0, 1e-9);
    const auto pose = poseAt(look, 1, 0);
    EXPECT_NEAR(pose[0].x(), 2.2, 1e-3);
    EXPECT_GT(pose[0].y(), 0.7);
    EXPECT_LT(look.low.y(), 0.1);
}

TEST_F(ImportTest, DroppedRecordingsOpenTheDialogPrefilled) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file("left.bvh")), QUrl::fromLocalFile(file("right.bvh"))});
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    QTRY_VERIFY(qobject_cast<ImportDialog*>(QApplication::activeModalWidget()) != nullptr);
    auto* dialog = static_cast<ImportDialog*>(QApplication::activeModalWidget());
    QTRY_VERIFY_WITH_TIMEOUT(!dialog->isBusy(), 30000);
    QTest::keyClick(dialog, Qt::Key_Return);
    settle();
    EXPECT_EQ(session().playerCount(), 2);
    EXPECT_TRUE(session().document().isModified());
}

TEST_F(ImportTest, ADropOnTheDialogGoesToTheFighterThatHasNoFile) {
    openDialog({file("left.bvh")});
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file("right.bvh"))});
    QDragEnterEvent enter({300, 400}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(dialog_.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(300, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(dialog_.get(), &drop);
    wait();
    pressOpen();
    ASSERT_EQ(dialog_->request().fighters.size(), 2U);
    EXPECT_EQ(dialog_->request().fighters[1].path, file("right.bvh").toStdString());
}

}  // namespace
}  // namespace kumite::studio
