#pragma once

#include <QString>

#include <vector>

#include "core/motion/body_model.h"

namespace kumite::studio {

/// A body model that users choose by name.
struct NamedBodyModel {
    QString text;
    BodyModel model;
};

/// The models that the studio brings.
const std::vector<NamedBodyModel>& broughtBodyModels();

}  // namespace kumite::studio
