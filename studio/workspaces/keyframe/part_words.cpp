#include "studio/workspaces/keyframe/part_words.h"

#include <QApplication>

namespace kumite::studio {

namespace {

QString text(const char* source) {
    return QApplication::translate("kumite::studio::PartWords", source);
}

}  // namespace

QString partText(BodyPart part) {
    switch (part) {
        case BodyPart::LeftArm:
            return text("left arm");
        case BodyPart::RightArm:
            return text("right arm");
        case BodyPart::LeftLeg:
            return text("left leg");
        case BodyPart::RightLeg:
            return text("right leg");
        case BodyPart::Trunk:
            return text("trunk, head");
    }
    return {};
}

}  // namespace kumite::studio
