#include "studio/view3d/stage_tools.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QWidgetAction>

#include "studio/app/icons.h"
#include "studio/app/theme.h"
#include "studio/view3d/stage_view.h"

namespace kumite::studio {

StageTools::StageTools(StageView& stage)
    : QWidget(&stage), stage_(stage), camera_(new QMenu(this)), overlays_(new QMenu(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    QToolButton* camera = addButton("camera", tr("Camera"), tr("Where the camera stands"));
    camera->setMenu(camera_);
    camera->setPopupMode(QToolButton::InstantPopup);
    QToolButton* overlays = addButton("eye", tr("Shown in 3D"), tr("What the 3D view shows"));
    overlays->setMenu(overlays_);
    overlays->setPopupMode(QToolButton::InstantPopup);
    measure_ = addButton("measure", tr("Measure"), {});
    refreshIcons();
}

QToolButton* StageTools::addButton(const QString& icon, const QString& name, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setProperty("line", icon);
    button->setAccessibleName(name);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    button->setIconSize({16, 16});
    layout()->addWidget(button);
    buttons_.append(button);
    return button;
}

void StageTools::setCameraActions(const QList<QAction*>& actions) {
    camera_->addActions(actions);
}

void StageTools::setOverlayActions(const QList<QAction*>& actions) {
    overlays_->addActions(actions);
    overlays_->addSeparator();
    auto* fields = new QWidgetAction(overlays_);
    fields->setDefaultWidget(trailFields(overlays_));
    overlays_->addAction(fields);
}

void StageTools::setMeasureAction(QAction* action) {
    measure_->setCheckable(true);
    measure_->setProperty("command", action->objectName());
    measure_->setToolTip(action->toolTip());
    connect(measure_, &QToolButton::clicked, action, &QAction::trigger);
    connect(action, &QAction::changed, measure_, [this, action] {
        measure_->setToolTip(action->toolTip());
        measure_->setChecked(action->isChecked());
        measure_->setEnabled(action->isEnabled());
    });
}

QWidget* StageTools::trailFields(QWidget* parent) {
    auto* fields = new QWidget(parent);
    auto* row = new QHBoxLayout(fields);
    row->setContentsMargins(24, 4, 12, 4);
    row->addWidget(new QLabel(tr("Trails, frames"), fields));
    const auto field = [&](const QString& name, const QString& prefix, int Overlays::*length) {
        auto* box = new QSpinBox(fields);
        box->setRange(0, Overlays::kLongestTrail);
        box->setSingleStep(10);
        box->setPrefix(prefix);
        box->setValue(stage_.overlays().*length);
        box->setAccessibleName(name);
        box->setToolTip(name);
        row->addWidget(box);
        connect(box, &QSpinBox::valueChanged, this, [this, length](int frames) {
            Overlays overlays = stage_.overlays();
            overlays.*length = frames;
            overlays.trails = true;
            stage_.setOverlays(overlays);
        });
        connect(&stage_, &StageView::switchesChanged, box, [this, box, length] {
            const QSignalBlocker blocked(box);
            box->setValue(stage_.overlays().*length);
        });
    };
    field(tr("Frames of trail before the shown one"), QStringLiteral("− "), &Overlays::trailBefore);
    field(tr("Frames of trail after the shown one"), QStringLiteral("+ "), &Overlays::trailAfter);
    return fields;
}

void StageTools::refreshIcons() {
    const QColor colour = coloursFor(palette()).text;
    for (QToolButton* button : buttons_)
        button->setIcon(lineIcon(button->property("line").toString(), colour));
}

void StageTools::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refreshIcons();
    QWidget::changeEvent(event);
}

}  // namespace kumite::studio
