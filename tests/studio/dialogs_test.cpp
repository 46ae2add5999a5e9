#include <gtest/gtest.h>

#include <QLabel>

#include "studio/app/keys_page.h"
#include "tests/studio/synthetic_bout.h"

namespace kumite::studio {
namespace {

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
