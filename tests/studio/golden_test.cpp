// Pictures of the views as they were when somebody last looked at them and found them good.

#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QPainter>
#include <QTest>

#include "studio/app/commands.h"
#include "studio/app/file_actions.h"
#include "studio/app/import/import_dialog.h"
#include "studio/app/theme.h"
#include "studio/timeline/timeline_view.h"
#include "studio/view3d/stage_view.h"
#include "studio/workspaces/segment/segment_panel.h"
#include "tests/studio/picture_comparison.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

/// A view in the light and in the dark theme.
class GoldenPictures : public WindowTest, public testing::WithParamInterface<ThemeChoice> {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        window_->setTheme(GetParam());
    }

    void TearDown() override {
        window_->setTheme(ThemeChoice::Dark);
        WindowTest::TearDown();
    }

    /// A boundary is selected, the playhead stands at it, some seconds are visible.
    void openScene() {
        openBout();
        session().setVisible({2.0, 7.0});
        session().goTo(someBoundary(1));
        QTest::qWait(300);  // edges are smoothed once the picture stands still
    }

    /// Half the size is enough to see by, and keeps the repository small.
    void expectGolden(const QString& view, const QImage& picture) {
        const QString theme = GetParam() == ThemeChoice::Dark ? "dark" : "light";
        const QString name = view + '-' + theme + ".png";
        const QImage now =
            picture.convertToFormat(QImage::Format_RGB32)
                .scaled(picture.size() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        const QDir kept(KUMITE_GOLDEN_FOLDER);
        const QDir fresh(KUMITE_FRESH_FOLDER);
        const QImage golden(kept.filePath(name));
        const PictureDifference difference = differenceOf(golden, now);
        if (looksAlike(difference)) {
            QFile::remove(fresh.filePath(name));
            return;
        }
        QDir().mkpath(fresh.path());
        ASSERT_TRUE(now.save(fresh.filePath(name), "PNG"));
        ADD_FAILURE() << (golden.isNull() ? "There is no golden picture " : "It differs from ")
                      << kept.filePath(name).toStdString() << " (" << 100 * difference.share
                      << " % of the cells, mean " << difference.mean << "). It looks now as in "
                      << fresh.filePath(name).toStdString()
                      << "; if that is as it should be: ./dev pictures --adopt";
    }
};

TEST_P(GoldenPictures, OfTheWelcomePage) {
    QTest::qWait(50);
    expectGolden("welcome", window_->centralWidget()->grab().toImage());
}

TEST_P(GoldenPictures, OfTheTimeline) {
    openScene();
    expectGolden("timeline", timeline().grab().toImage());
}

TEST_P(GoldenPictures, OfTheStage) {
    openScene();
    expectGolden("stage", window_->stage().picture());
}

TEST_P(GoldenPictures, OfTheSegmentPanel) {
    openScene();
    auto* panel = window_->findChild<SegmentPanel*>();
    ASSERT_NE(panel, nullptr);
    expectGolden("segment", panel->grab().toImage());
}

TEST_P(GoldenPictures, OfTheImportDialog) {
    window_->files().showImportDialog(recordings());
    auto* dialog = window_->findChild<ImportDialog*>();
    ASSERT_NE(dialog, nullptr);
    // The folder of the recordings is another one each time.
    QTest::qWait(800);
    for (auto* field : dialog->findChildren<QLineEdit*>()) {
        const QSignalBlocker blocked(field);
        if (field->text().endsWith(".bvh")) field->setText(QFileInfo(field->text()).fileName());
    }
    expectGolden("import", dialog->grab().toImage());
    dialog->reject();
}

INSTANTIATE_TEST_SUITE_P(Themes, GoldenPictures,
                         testing::Values(ThemeChoice::Light, ThemeChoice::Dark),
                         [](const auto& theme) {
                             return theme.param == ThemeChoice::Dark ? "Dark" : "Light";
                         });

/// What tells pictures apart, and what does not.
class Comparison : public testing::Test {
protected:
    QImage scene(const QPoint& block, const QColor& colour = QColor("#56b4e9")) {
        QImage picture(320, 200, QImage::Format_RGB32);
        picture.fill(QColor("#1e1f22"));
        QPainter painter(&picture);
        painter.fillRect(QRect(block, QSize(80, 60)), colour);
        painter.setPen(QColor("#e8e8e8"));
        for (int y = 8; y < 200; y += 24)
            painter.drawText(200, y + 10, "fighter 1 at 0.72 BW");
        return picture;
    }
};

TEST_F(Comparison, ForgivesWhatAnotherMachineDrawsALittleOtherwise) {
    const QImage golden = scene({40, 40});
    EXPECT_TRUE(looksAlike(differenceOf(golden, golden)));
    EXPECT_TRUE(looksAlike(differenceOf(golden, scene({41, 40}))));
    EXPECT_TRUE(looksAlike(differenceOf(golden, scene({40, 40}, QColor("#59b6e6")))));
}

TEST_F(Comparison, SeesWhatIsMovedMissingOrOfAnotherColour) {
    const QImage golden = scene({40, 40});
    EXPECT_FALSE(looksAlike(differenceOf(golden, scene({60, 40}))));
    EXPECT_FALSE(looksAlike(differenceOf(golden, scene({400, 40}))));
    EXPECT_FALSE(looksAlike(differenceOf(golden, scene({40, 40}, QColor("#d55e00")))));
    EXPECT_FALSE(looksAlike(differenceOf(golden, golden.scaled(300, 200))));
    EXPECT_FALSE(looksAlike(differenceOf(QImage(), golden)));
}

}  // namespace
}  // namespace kumite::studio
