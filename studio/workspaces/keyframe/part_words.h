#pragma once

#include <QString>

#include "core/editing/body_parts.h"

namespace kumite::studio {

/// A part of the body as it is spoken of.
QString partText(BodyPart part);

}  // namespace kumite::studio
