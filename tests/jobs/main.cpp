// Work beside the window, tested without one: for the thread sanitizer.

#include <gtest/gtest.h>

#include <QCoreApplication>

#include "studio/app/language.h"

/// What is said is said in English; choosing another language needs a window.
QString kumite::studio::languageInUse() {
    return QStringLiteral("en");
}

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const QCoreApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
