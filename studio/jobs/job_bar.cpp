#include "studio/jobs/job_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "studio/jobs/job_runner.h"

namespace kumite::studio {

JobBar::JobBar(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->setSpacing(8);
    layout->addWidget(title_);
    layout->addWidget(bar_);
    layout->addWidget(cancel_);
    bar_->setFixedWidth(120);
    bar_->setRange(0, 100);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress"));
    cancel_->setStyleSheet(QStringLiteral("padding: 0 8px;"));
    cancel_->setFocusPolicy(Qt::TabFocus);
    delay_.setSingleShot(true);
    delay_.setInterval(200);
    hide();
    connect(&delay_, &QTimer::timeout, this, &QWidget::show);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        if (shown_ != nullptr) shown_->cancel();
    });
}

void JobBar::watch(JobRunner& runner) {
    JobRunner* source = &runner;
    connect(source, &JobRunner::started, this, [this, source](const QString& title) {
        shown_ = source;
        title_->setText(title);
        bar_->setValue(0);
        delay_.start();
    });
    connect(source, &JobRunner::progressed, this, [this, source](double fraction) {
        if (shown_ == source) bar_->setValue(static_cast<int>(fraction * 100));
    });
    connect(source, &JobRunner::finished, this, [this, source] {
        if (shown_ != source) return;
        shown_ = nullptr;
        delay_.stop();
        hide();
    });
}

}  // namespace kumite::studio
