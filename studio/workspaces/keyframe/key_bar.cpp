#include "studio/workspaces/keyframe/key_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <cmath>

#include "studio/app/panel_parts.h"
#include "studio/app/words.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/key_session.h"

namespace kumite::studio {

KeyBar::KeyBar(KeySession& keys, HitSession& hit, CommandTable& commands, QWidget* parent)
    : QWidget(parent), keys_(keys), hit_(hit), time_(new QLabel(this)), what_(new QLabel(this)) {
    setFixedHeight(30);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 12, 2);
    layout->setSpacing(2);
    for (const char* command : {"keys.start", "keys.back", "keys.play", "keys.on", "keys.end"})
        layout->addWidget(iconButton(commands, command, this));
    layout->addSpacing(10);
    showAsClock(time_, tr("Time of the keys"));
    layout->addWidget(time_);
    layout->addSpacing(8);
    what_->setProperty("role", "second");
    layout->addWidget(what_);
    layout->addStretch(1);
    for (auto signal : {&KeySession::moved, &KeySession::stateChanged, &KeySession::motionChanged})
        connect(&keys_, signal, this, &KeyBar::refresh);
    connect(&hit_, &HitSession::changed, this, &KeyBar::refresh);
    connect(&hit_, &HitSession::moved, this, &KeyBar::refresh);
    refresh();
}

void KeyBar::refresh() {
    if (hit_.isOn()) {
        time_->setText(timeText(hit_.seconds()));
        what_->setText(hit_.motion() ? tr("the strike") : QString());
        return;
    }
    time_->setText(timeText(keys_.frame() / keys_.rate()));
    QString text = tr("frame %1").arg(std::lround(keys_.frame()));
    if (!keys_.draft().track.keys.empty())
        text += keys_.showsMotion() ? tr(" · the motion") : tr(" · the keys");
    if (keys_.directPose()) text += tr(" · beside it without adjustment");
    if (keys_.missing() > 0.01)
        text += tr(" · out of reach by %1 cm").arg(numberText(100 * keys_.missing(), 0));
    what_->setText(text);
}

}  // namespace kumite::studio
