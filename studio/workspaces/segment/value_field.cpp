#include "studio/workspaces/segment/value_field.h"
#include "studio/app/language.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

double SliderScale::valueAt(int step) const {
    const double share = static_cast<double>(step) / steps;
    return low + (high - low) * share * share;
}

int SliderScale::stepOf(double value) const {
    const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return static_cast<int>(std::lround(std::sqrt(share) * steps));
}

ValueField::ValueField(const SliderScale& scale, const Look& look, QWidget* parent)
    : QWidget(parent),
      scale_(scale),
      slider_(new QSlider(Qt::Horizontal, this)),
      field_(new QDoubleSpinBox(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    slider_->setRange(0, scale.steps);
    slider_->setPageStep(scale.steps / 20);
    slider_->setMinimumWidth(48);
    slider_->setAccessibleName(look.name);
    slider_->setToolTip(look.toolTip);
    field_->setRange(scale.low, look.highest);
    field_->setDecimals(look.decimals);
    field_->setSingleStep(look.step);
    field_->setSuffix(look.suffix);
    field_->setLocale(fieldLocale());
    field_->setKeyboardTracking(false);
    field_->setAlignment(Qt::AlignRight);
    field_->setAccessibleName(look.name);
    field_->setToolTip(look.toolTip);
    // Fields below each other are as wide as each other.
    field_->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.000 BW")) + 20);
    layout->addWidget(slider_, 1);
    layout->addWidget(field_);
    connect(slider_, &QSlider::valueChanged, this, [this](int step) {
        if (showing_) return;
        // As many digits as the field shows.
        const double unit = std::pow(10.0, field_->decimals());
        setValue(std::round(scale_.valueAt(step) * unit) / unit);
        Q_EMIT chosen(value_);
    });
    // An arrow key is a step of the field, which the scale may have several or none for.
    connect(slider_, &QSlider::actionTriggered, this, [this](int action) {
        const int way = action == QAbstractSlider::SliderSingleStepAdd   ? 1
                        : action == QAbstractSlider::SliderSingleStepSub ? -1
                                                                         : 0;
        if (way == 0) return;
        const int step = scale_.stepOf(value_ + way * field_->singleStep());
        const int now = slider_->value();
        slider_->setSliderPosition(way > 0 ? std::max(step, now + 1) : std::min(step, now - 1));
    });
    connect(slider_, &QSlider::sliderReleased, this, &ValueField::released);
    connect(field_, &QDoubleSpinBox::valueChanged, this, &ValueField::fieldEdited);
}

void ValueField::setValue(double value) {
    value_ = value;
    showing_ = true;
    if (!slider_->isSliderDown()) slider_->setValue(scale_.stepOf(value));
    field_->setValue(value);
    showing_ = false;
}

bool ValueField::isDragged() const {
    return slider_->isSliderDown();
}

void ValueField::fieldEdited() {
    if (showing_) return;
    // A value that the field cannot show exactly stays while nobody changes what it shows.
    if (field_->text() == field_->textFromValue(value_) + field_->suffix()) return;
    value_ = field_->value();
    showing_ = true;
    slider_->setValue(scale_.stepOf(value_));
    showing_ = false;
    Q_EMIT chosen(value_);
}

}  // namespace kumite::studio
