#include "studio/workspaces/sequence/sequence_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/sequence/sequence_session.h"
#include "studio/workspaces/sequence/transition_box.h"

namespace kumite::studio {

SequenceBar::SequenceBar(SequenceSession& sequence, CommandTable& commands, QWidget* parent)
    : QWidget(parent), sequence_(sequence), time_(new QLabel(this)), what_(new QLabel(this)) {
    setFixedHeight(30);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 12, 2);
    layout->setSpacing(2);
    for (const char* command : {"sequence.start", "sequence.back", "sequence.play", "sequence.on",
                                "sequence.end", "sequence.loop"})
        layout->addWidget(iconButton(commands, command, this));
    layout->addSpacing(10);
    showAsClock(time_, tr("Time of the sequence"));
    layout->addWidget(time_);
    layout->addSpacing(8);
    what_->setProperty("role", "second");
    layout->addWidget(what_);
    layout->addStretch(1);
    for (auto signal :
         {&SequenceSession::moved, &SequenceSession::stateChanged, &SequenceSession::motionChanged})
        connect(&sequence_, signal, this, &SequenceBar::refresh);
    refresh();
}

void SequenceBar::refresh() {
    const bool live = sequence_.showing() == SequenceSession::Showing::Live;
    time_->setText(live ? QStringLiteral("–") : timeText(sequence_.seconds()));
    QString text;
    switch (sequence_.showing()) {
        case SequenceSession::Showing::Sequence:
            if (sequence_.length() > 0) text = tr("of %1").arg(timeText(sequence_.length(), 0.1));
            break;
        case SequenceSession::Showing::Action:
            text = tr("the chosen action, %1 s; Esc: back to the sequence")
                       .arg(numberText(sequence_.length(), 2));
            break;
        case SequenceSession::Showing::Live: {
            const auto& report = sequence_.liveReport();
            text = tr("live: 1 … 9 play blocks at once");
            if (report) {
                text += tr(" · last %1, cost %2")
                            .arg(TransitionBox::wayOf(*report), numberText(report->cost(), 1));
            }
            break;
        }
    }
    what_->setText(text);
}

}  // namespace kumite::studio
