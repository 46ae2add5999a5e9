#include "studio/workspaces/bout/bout_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/bout/bout_session.h"

namespace kumite::studio {

BoutBar::BoutBar(BoutSession& bout, CommandTable& commands, QWidget* parent)
    : QWidget(parent),
      bout_(bout),
      time_(new QLabel(this)),
      end_(new QLabel(this)),
      speed_(new QLabel(this)) {
    setFixedHeight(30);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 12, 2);
    layout->setSpacing(2);
    for (const char* command : {"bout.start", "bout.back", "bout.play", "bout.on", "bout.end"})
        layout->addWidget(iconButton(commands, command, this));
    layout->addSpacing(10);
    showAsClock(time_, tr("Time of the bout"));
    layout->addWidget(time_);
    layout->addSpacing(8);
    for (QLabel* label : {end_, speed_}) {
        label->setProperty("role", "second");
        layout->addWidget(label);
        layout->addSpacing(8);
    }
    end_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("of %1").arg("00:00.0")));
    layout->addStretch(1);
    connect(&bout_, &BoutSession::moved, this, &BoutBar::showMoment);
    connect(&bout_, &BoutSession::begun, this, &BoutBar::showMoment);
    connect(&bout_, &BoutSession::stateChanged, this, &BoutBar::showMoment);
    showMoment();
}

void BoutBar::showMoment() {
    const BoutTape* tape = bout_.tape();
    time_->setText(timeText(tape ? tape->frame() / bout_.rate() : 0));
    const bool back = tape != nullptr && tape->frame() < tape->end();
    end_->setText(back ? tr("of %1").arg(timeText(tape->end() / bout_.rate(), 0.1)) : QString());
    speed_->setText(bout_.speed() == 1.0 ? QString()
                                         : numberText(bout_.speed()) + QStringLiteral("×"));
}

}  // namespace kumite::studio
