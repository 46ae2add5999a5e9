#pragma once

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace kumite::studio {

/// A row of buttons, boxes and sliders at the top of a page beside the 3D view; what is added first
/// stands left.
inline QHBoxLayout* addChooserRow(QVBoxLayout& page) {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(6);
    page.addLayout(row);
    return row;
}

}  // namespace kumite::studio
