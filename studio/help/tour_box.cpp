#include "studio/help/tour_box.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include "studio/app/commands.h"
#include "studio/help/tour.h"

namespace kumite::studio {

TourBox::TourBox(CommandTable& commands, QWidget* window)
    : QFrame(window),
      title_(new QLabel(this)),
      text_(new QLabel(this)),
      done_(new QLabel(this)),
      help_(new QPushButton(this)),
      back_(new QPushButton(tr("Back"), this)),
      next_(new QPushButton(this)) {
    setProperty("role", "tour");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 12, 14, 12);
    layout->setSpacing(8);
    title_->setProperty("role", "heading");
    layout->addWidget(title_);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::RichText);
    layout->addWidget(text_);
    layout->addWidget(help_);
    done_->setText(tr("✓ Done"));
    done_->setAccessibleName(tr("This step is done"));
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(done_, 1);
    auto* leave = new QPushButton(tr("Leave"), this);
    for (const auto& [button, command] :
         {std::pair{leave, "help.tour.leave"}, std::pair{back_, "help.tour.back"},
          std::pair{next_, "help.tour.next"}}) {
        row->addWidget(button);
        commands.tellKey(button, QLatin1String(command));
        connect(button, &QPushButton::clicked, commands.action(QLatin1String(command)),
                &QAction::trigger);
    }
    layout->addLayout(row);
    for (auto* button : findChildren<QPushButton*>()) {
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoDefault(false);
    }
    connect(help_, &QPushButton::clicked, this, &TourBox::helpWanted);
    QFrame::hide();
}

void TourBox::show(const TourStep& step, int number, int count) {
    title_->setText(tr("%1 of %2: %3").arg(number).arg(count).arg(step.title));
    text_->setText(step.text());
    setAccessibleName(tr("Tour, step %1").arg(title_->text()));
    setAccessibleDescription(text_->text());
    help_->setVisible(step.help != nullptr);
    help_->setEnabled(true);
    help_->setText(step.helpText);
    help_->setToolTip(step.helpText);
    back_->setEnabled(number > 1);
    next_->setText(number == count ? tr("Finish") : tr("Next"));
    setFixedWidth(fontMetrics().averageCharWidth() * 50);
    QFrame::show();
    raise();
}

void TourBox::setDone(bool done) {
    done_->setVisible(done);
    next_->setProperty("role", done ? "step" : "");
    next_->style()->unpolish(next_);
    next_->style()->polish(next_);
    next_->setMinimumWidth(next_->sizeHint().width());
    // The text wraps: its height follows from the width.
    setFixedHeight(layout()->heightForWidth(width()));
}

bool TourBox::showsDone() const {
    return done_->isVisible();
}

QString TourBox::text() const {
    return text_->text();
}

}  // namespace kumite::studio
