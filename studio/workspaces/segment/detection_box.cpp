#include "studio/workspaces/segment/detection_box.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/project/edits.h"
#include "core/project/report.h"
#include "studio/app/core_words.h"
#include "studio/app/session.h"
#include "studio/workspaces/segment/value_field.h"

namespace kumite::studio {

SettingsFields::SettingsFields(const QString& suffix, QWidget* parent)
    : QWidget(parent),
      cutoff_(new ValueField(
          {0.5, 20.0, 390},
          {tr("Cutoff of the low-pass in Hz") + suffix,
           tr("Low-pass over the centre of mass: lower gives smoother curves and fewer minima."),
           tr(" Hz"), 1, 0.5, 60.0},
          this)),
      prominence_(new ValueField(
          {0.0, 0.5, 500},
          {tr("Least prominence in body weights") + suffix,
           tr("A minimum must be at least this deep to be a boundary."), tr(" BW"), 3, 0.01, 5.0},
          this)),
      curve_(new QComboBox(this)) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(4);
    form->setHorizontalSpacing(6);
    form->addRow(tr("Cutoff"), cutoff_);
    form->addRow(tr("Promin."), prominence_);
    form->addRow(tr("Curve"), curve_);
    curve_->addItem(tr("length of the force"), static_cast<int>(ForceCurve::Norm));
    curve_->addItem(tr("vertical part"), static_cast<int>(ForceCurve::Vertical));
    curve_->setAccessibleName(tr("Curve that is cut at its minima") + suffix);
    curve_->setToolTip(
        tr("Which curve is cut at its minima: the length of the contact force or "
           "its vertical part."));
    for (ValueField* field : {cutoff_, prominence_}) {
        connect(field, &ValueField::chosen, this, &SettingsFields::chosen);
        connect(field, &ValueField::released, this, &SettingsFields::released);
    }
    connect(curve_, &QComboBox::currentIndexChanged, this, &SettingsFields::chosen);
}

SegmentationSettings SettingsFields::settings() const {
    return {cutoff_->value(), prominence_->value(),
            static_cast<ForceCurve>(curve_->currentData().toInt())};
}

void SettingsFields::show(const SegmentationSettings& settings) {
    const QSignalBlocker quiet(curve_);
    cutoff_->setValue(settings.cutoff);
    prominence_->setValue(settings.prominence);
    curve_->setCurrentIndex(curve_->findData(static_cast<int>(settings.curve)));
}

bool SettingsFields::isDragged() const {
    return cutoff_->isDragged() || prominence_->isDragged();
}

DetectionBox::DetectionBox(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      fields_(new SettingsFields({}, this)),
      warning_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(fields_);
    warning_->setWordWrap(true);
    warning_->setAccessibleName(tr("Warning about the cutoff"));
    layout->addWidget(warning_);
    connect(fields_, &SettingsFields::chosen, this, &DetectionBox::choose);
    connect(fields_, &SettingsFields::released, this, [this] {
        act();
        session_.document().endGesture();
    });
    Document& document = session_.document();
    connect(&document, &Document::changed, this, &DetectionBox::showSettings);
    connect(&document, &Document::analysisChanged, this, [this] {
        showFindings();
        act();
    });
    showSettings();
    showFindings();
}

void DetectionBox::choose() {
    if (!session_.document().isOpen()) return;
    waiting_ = fields_->settings();
    // While values are computed a slider waits for them, so that something is seen on the way.
    if (!fields_->isDragged() || !session_.document().isComputing()) act();
}

void DetectionBox::act() {
    if (!waiting_) return;
    const SegmentationSettings settings = *waiting_;
    waiting_.reset();
    Document& document = session_.document();
    const auto edit = [&](const Project& project) { return setSegmentation(project, settings); };
    document.applyLive(QStringLiteral("segmentation"), edit);
    if (!fields_->isDragged()) document.endGesture();
}

void DetectionBox::showSettings() {
    if (!waiting_) fields_->show(session_.document().project().segmentation);
}

void DetectionBox::showFindings() {
    const Document& document = session_.document();
    QStringList lines;
    for (const Finding& finding : smoothingFindings(document.project(), document.analysis())) {
        lines.append(QStringLiteral("⚠ ") + coreWords(finding.text));
    }
    warning_->setText(lines.join(QLatin1Char('\n')));
    warning_->setVisible(!lines.isEmpty());
}

}  // namespace kumite::studio
