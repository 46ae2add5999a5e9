#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <numbers>

#include "studio/app/import_dialog.h"
#include "studio/app/keys_page.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

QLineEdit* field(ImportDialog& dialog, const QString& name) {
    for (auto* each : dialog.findChildren<QLineEdit*>()) {
        if (each->accessibleName() == name) return each;
    }
    ADD_FAILURE() << name.toStdString();
    return nullptr;
}

void openBoutIn(ImportDialog& dialog) {
    for (auto* button : dialog.findChildren<QPushButton*>()) {
        if (button->text() == "Open bout") button->click();
    }
}

TEST(ImportDialog, LeavesToBeFoundWhatIsLeftBlank) {
    ImportDialog dialog({"a.bvh", "b.bvh"}, {}, nullptr);
    openBoutIn(dialog);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    const TakeRequest request = dialog.request();
    ASSERT_EQ(request.fighters.size(), 2U);
    EXPECT_EQ(request.fighters[1].path, "b.bvh");
    EXPECT_FALSE(request.rate.has_value());
    EXPECT_FALSE(request.trim.has_value());
    EXPECT_FALSE(request.fighters[0].metresPerUnit.has_value());
    EXPECT_FALSE(dialog.addsToProject());
}

TEST(ImportDialog, TakesWhatTheUserSays) {
    ImportDialog dialog({"a.bvh", "b.bvh"}, "bout.kumite", nullptr);
    field(dialog, "Take name")->setText("round 1");
    field(dialog, "Rate in Hz")->setText("59.94");
    field(dialog, "Frames, begin:end")->setText("120:");
    field(dialog, "Offset of fighter 2 in seconds")->setText("0.25");
    field(dialog, "Fighter 2: x in metres")->setText("1.5");
    field(dialog, "Fighter 2: turn in degrees")->setText("180");
    for (auto* box : dialog.findChildren<QComboBox*>()) {
        if (box->accessibleName() == "Unit of length") box->setCurrentText("inch");
    }
    for (auto* button : dialog.findChildren<QPushButton*>()) {
        if (button->text() == "Swap fighters") button->click();
    }
    openBoutIn(dialog);
    const TakeRequest request = dialog.request();
    EXPECT_EQ(request.name, "round 1");
    EXPECT_DOUBLE_EQ(request.rate.value(), 59.94);
    EXPECT_EQ(request.trim.value(), (FrameRange{120, -1}));
    EXPECT_EQ(request.fighters[0].path, "b.bvh");
    EXPECT_DOUBLE_EQ(request.fighters[1].offset, 0.25);
    EXPECT_DOUBLE_EQ(request.fighters[1].placement.x, 1.5);
    EXPECT_NEAR(request.fighters[1].placement.yaw, std::numbers::pi, 1e-12);
    EXPECT_NEAR(request.fighters[0].metresPerUnit.value(), 0.0254, 1e-12);
    EXPECT_TRUE(dialog.addsToProject());
}

TEST(ImportDialog, SaysWhatIsWrongAndStays) {
    for (const auto& [name, text] : {std::pair("Rate in Hz", "fast"),
                                     {"Rate in Hz", "-60"},
                                     {"Frames, begin:end", "900:120"},
                                     {"Frames, begin:end", "5"},
                                     {"Offset of fighter 2 in seconds", "1,5"}}) {
        ImportDialog dialog({"a.bvh", "b.bvh"}, {}, nullptr);
        dialog.show();
        field(dialog, name)->setText(text);
        openBoutIn(dialog);
        EXPECT_TRUE(dialog.isVisible()) << text;
    }
    ImportDialog empty({}, {}, nullptr);
    empty.show();
    openBoutIn(empty);
    EXPECT_TRUE(empty.isVisible());
}

TEST_F(WindowTest, KeysPageIsMadeOfTheCommandTable) {
    KeysPage page(window_->commands(), window_.get());
    QStringList texts;
    for (const auto* label : page.findChildren<QLabel*>())
        texts.append(label->text());
    EXPECT_TRUE(texts.contains("Ctrl+Z"));
    EXPECT_TRUE(texts.contains("Remove or restore boundary"));
    EXPECT_TRUE(texts.contains("Mouse on the timeline"));
}

}  // namespace
}  // namespace kumite::studio
