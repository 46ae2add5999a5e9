#pragma once

#include <QVBoxLayout>

#include "studio/app/flow_row.h"

namespace kumite::studio {

/// A row of buttons, boxes and sliders at the top of a page beside the 3D view; what is added first
/// stands left. It goes on in a second line where it has to.
inline FlowRow* addChooserRow(QVBoxLayout& page) {
    auto* row = new FlowRow;
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(6);
    page.addLayout(row);
    return row;
}

}  // namespace kumite::studio
