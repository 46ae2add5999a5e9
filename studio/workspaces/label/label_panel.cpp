#include "studio/workspaces/label/label_panel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/progress_box.h"

namespace kumite::studio {

namespace {

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "heading");
    return label;
}

}  // namespace

LabelPanel::LabelPanel(LabelSession& labels, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      progress_(new ProgressBox(labels, this)),
      action_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(5);
    layout->addWidget(heading(tr("Labels"), this));
    layout->addWidget(progress_);
    layout->addSpacing(3);
    layout->addWidget(heading(tr("This action"), this));
    action_->setWordWrap(true);
    action_->setProperty("role", "second");
    action_->setAlignment(Qt::AlignTop);
    action_->setAccessibleName(tr("Label of the current action"));
    layout->addWidget(action_);
    layout->addStretch(1);
    setMinimumWidth(200);
    connect(&labels_, &LabelSession::changed, this, &LabelPanel::showLabels);
    connect(&labels_, &LabelSession::choiceChanged, this, &LabelPanel::showChoice);
    showLabels();
}

void LabelPanel::showLabels() {
    progress_->refresh();
    showChoice();
}

void LabelPanel::showChoice() {
    const ShownAction* action = labels_.current();
    if (action == nullptr) return action_->setText(tr("No action is at the playhead."));
    action_->setText(
        QString::fromStdString(labelText(labels_.vocabulary(), action->label(), true)));
}

}  // namespace kumite::studio
