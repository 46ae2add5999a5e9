#include "studio/workspaces/keyframe/part_words.h"

#include <QApplication>
#include <QCoreApplication>

namespace kumite::studio {

namespace {

/// Translations of this file.
struct PartWords {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::PartWords)
};

}  // namespace

QString partText(BodyPart part) {
    switch (part) {
        case BodyPart::LeftArm:
            return PartWords::tr("left arm");
        case BodyPart::RightArm:
            return PartWords::tr("right arm");
        case BodyPart::LeftLeg:
            return PartWords::tr("left leg");
        case BodyPart::RightLeg:
            return PartWords::tr("right leg");
        case BodyPart::Trunk:
            return PartWords::tr("trunk, head");
    }
    return {};
}

}  // namespace kumite::studio
