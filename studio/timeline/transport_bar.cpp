#include "studio/timeline/transport_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include <cmath>

#include "studio/app/commands.h"
#include "studio/app/panel_parts.h"
#include "studio/app/session.h"
#include "studio/app/words.h"

namespace kumite::studio {

TransportBar::TransportBar(Session& session, CommandTable& commands, QWidget* parent)
    : QWidget(parent),
      session_(session),
      time_(new QLabel(this)),
      frame_(new QLabel(this)),
      speed_(new QLabel(this)),
      selection_(new QLabel(this)) {
    setFixedHeight(30);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 12, 2);
    layout->setSpacing(2);
    for (const char* command : {"transport.begin", "transport.back", "transport.play",
                                "transport.on", "transport.end", "transport.loop"}) {
        layout->addWidget(iconButton(commands, command, this));
    }
    layout->addSpacing(10);
    showAsClock(time_, tr("Time"));
    layout->addWidget(time_);
    layout->addSpacing(8);
    frame_->setProperty("role", "second");
    frame_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("frame %1").arg(88888)));
    layout->addWidget(frame_);
    layout->addSpacing(8);
    speed_->setProperty("role", "second");
    speed_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("−0.10×")));
    speed_->setToolTip(tr("Playback speed: - slower, + faster"));
    layout->addWidget(speed_);
    selection_->setProperty("role", "second");
    // A long text asks for no wider window.
    selection_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    selection_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(selection_, 1);
    layout->addSpacing(8);
    addRowChooser(commands, layout);
    connect(&session_.transport(), &Transport::moved, this, &TransportBar::showMoment);
    connect(&session_.transport(), &Transport::stateChanged, this, &TransportBar::showState);
    connect(&session_, &Session::takeChanged, this, &TransportBar::showMoment);
    connect(&session_, &Session::activePlayerChanged, this, &TransportBar::showMoment);
    connect(&session_, &Session::fightersChanged, this, &TransportBar::showMoment);
    connect(&session_, &Session::selectionChanged, this, &TransportBar::showMoment);
    showMoment();
    showState();
}

void TransportBar::addRowChooser(CommandTable& commands, QHBoxLayout* layout) {
    auto* rows = new QToolButton(this);
    auto* menu = new QMenu(rows);
    for (const char* command :
         {"timeline.height", "timeline.rawForce", "timeline.handSpeed", "timeline.footSpeed"}) {
        menu->addAction(commands.action(QLatin1String(command)));
    }
    menu->addSeparator();
    for (const char* command :
         {"timeline.rulerBoth", "timeline.rulerTime", "timeline.rulerFrames"}) {
        menu->addAction(commands.action(QLatin1String(command)));
    }
    rows->setText(tr("Rows ▾"));
    rows->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    rows->setAccessibleName(tr("Rows of the timeline"));
    rows->setToolTip(tr("What the timeline shows: curves, speeds, units of the ruler"));
    rows->setMenu(menu);
    rows->setPopupMode(QToolButton::InstantPopup);
    rows->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(rows);
}

void TransportBar::showMoment() {
    time_->setText(timeText(session_.transport().shownTime()));
    const int player = session_.activePlayer();
    const FighterAnalysis* fighter = session_.fighter(player);
    frame_->setText(fighter ? tr("frame %1").arg(session_.shownFrame(player)) : QString());
    if (const auto& selected = session_.selection()) {
        selected_ = tr("selected: boundary of %1 at %2")
                        .arg(fighterText(selected->player), timeText(session_.timeOf(*selected)));
    } else if (const auto& action = session_.selectedAction()) {
        const TimeSpan span = session_.spanOf(*action);
        const QString note = session_.noteOf(*action);
        const QString text =
            tr("selected: action of %1, %2 to %3")
                .arg(fighterText(action->player), timeText(span.begin), timeText(span.end));
        selected_ = note.isEmpty()
                        ? text
                        : text + QStringLiteral(" · ") +
                              fontMetrics().elidedText(note, Qt::ElideRight,
                                                       30 * fontMetrics().averageCharWidth());
        selection_->setToolTip(note);
    } else {
        selected_ = fighter ? tr("active: %1").arg(fighterText(player)) : QString();
    }
    fitSelection();
}

void TransportBar::fitSelection() {
    selection_->setText(
        selection_->fontMetrics().elidedText(selected_, Qt::ElideRight, selection_->width()));
}

void TransportBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    fitSelection();
}

void TransportBar::showState() {
    const double speed = session_.transport().speed();
    const int decimals = std::abs(speed * 10 - std::round(speed * 10)) < 0.01 ? 1 : 2;
    const QString size = numberText(std::abs(speed), speed == std::round(speed) ? 0 : decimals);
    speed_->setText((speed < 0 ? QStringLiteral("−") : QString()) + size + QStringLiteral("×"));
}

}  // namespace kumite::studio
