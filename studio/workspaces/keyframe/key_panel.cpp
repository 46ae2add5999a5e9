#include "studio/workspaces/keyframe/key_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include <utility>

#include "studio/app/commands.h"
#include "studio/workspaces/keyframe/hit_box.h"
#include "studio/workspaces/keyframe/hit_session.h"
#include "studio/workspaces/keyframe/joint_box.h"
#include "studio/workspaces/keyframe/key_session.h"
#include "studio/workspaces/keyframe/motion_box.h"
#include "studio/workspaces/keyframe/pose_box.h"

namespace kumite::studio {

KeyPanel::KeyPanel(KeySession& keys, HitSession& hit, QWidget* parent)
    : QStackedWidget(parent),
      keys_(keys),
      hit_(hit),
      tools_(new QStackedWidget(this)),
      pages_(new QTabWidget(tools_)),
      buttons_(new QHBoxLayout),
      empty_(new QWidget(this)),
      full_(new QWidget(this)),
      why_(new QLabel(empty_)) {
    auto* none = new QVBoxLayout(empty_);
    none->setContentsMargins(8, 8, 8, 8);
    none->setSpacing(8);
    why_->setWordWrap(true);
    why_->setProperty("role", "second");
    why_->setAccessibleName(tr("What appears here"));
    none->addWidget(why_);
    none->addStretch(1);
    auto* layout = new QVBoxLayout(full_);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(10);
    pages_->setDocumentMode(true);
    auto* pose = new QWidget(pages_);
    auto* parts = new QVBoxLayout(pose);
    parts->setContentsMargins(0, 8, 0, 0);
    parts->setSpacing(10);
    parts->addWidget(new PoseBox(keys_, pose));
    parts->addWidget(new JointBox(keys_, pose));
    parts->addStretch(1);
    pages_->addTab(pose, tr("Key pose"));
    pages_->addTab(new MotionBox(keys_, pages_), tr("Motion"));
    tools_->addWidget(pages_);
    tools_->addWidget(new HitBox(hit_, tools_));
    layout->addWidget(tools_, 1);
    buttons_->setSpacing(4);
    layout->addLayout(buttons_);
    addWidget(empty_);
    addWidget(full_);
    connect(&keys_, &KeySession::libraryChanged, this, &KeyPanel::refresh);
    connect(&keys_, &KeySession::stateChanged, this, &KeyPanel::refresh);
    connect(&hit_, &HitSession::changed, this, &KeyPanel::refresh);
    refresh();
}

void KeyPanel::addCommands(CommandTable& commands) {
    auto* tool = new QPushButton(tr("Hit a target"), full_);
    tool->setCheckable(true);
    tool->setFocusPolicy(Qt::TabFocus);
    tool->setToolTip(tr("A strike of the takes and clips that follows a target, instead of keys"));
    commands.tellKey(tool, QStringLiteral("keys.hit"));
    connect(tool, &QPushButton::clicked, commands.action(QStringLiteral("keys.hit")),
            &QAction::trigger);
    connect(&hit_, &HitSession::changed, tool, [this, tool] {
        tool->setChecked(hit_.isOn());
        tool->setText(hit_.isOn() ? tr("Back to the keys") : tr("Hit a target"));
    });
    static_cast<QVBoxLayout*>(full_->layout())->insertWidget(0, tool);
    const QString menu = commands.find(QStringLiteral("keys.hit"))->menu;
    const std::pair<const char*, QString> pages[] = {{"keys.page.pose", tr("Sho&w the key pose")},
                                                     {"keys.page.motion", tr("Show the motio&n")}};
    for (int page = 0; page < 2; ++page) {
        const auto& [id, text] = pages[page];
        commands.add({QLatin1String(id),
                      (page == 0 ? QStringLiteral("-") : QString()) + menu,
                      text,
                      {QKeySequence(Qt::Key_1 + page)},
                      [this, page] { pages_->setCurrentIndex(page); },
                      [this] { return keys_.library() != nullptr && !hit_.isOn(); },
                      [this, page] { return pages_->currentIndex() == page; }});
    }
    connect(pages_, &QTabWidget::currentChanged, &commands, &CommandTable::refresh);
    const std::pair<const char*, QString> all[] = {
        {"keys.clips", tr("Clips…")}, {"keys.keep", tr("Keep…")}, {"keys.export", tr("Export…")}};
    for (const auto& [id, text] : all) {
        const QAction* action = commands.action(QLatin1String(id));
        auto* button = new QPushButton(text, full_);
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolTip(commands.find(QLatin1String(id))->plainText());
        commands.tellKey(button, QLatin1String(id));
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        buttons_->addWidget(button, 1);
    }
}

void KeyPanel::addStep(const QString& text, const QString& tip, std::function<void()> run) {
    auto* button = new QPushButton(text, empty_);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, std::move(run));
    auto* layout = static_cast<QVBoxLayout*>(empty_->layout());
    layout->insertWidget(layout->count() - 1, button);
}

void KeyPanel::refresh() {
    const QString why = keys_.whyNothing();
    why_->setText(!why.isEmpty() ? why
                                 : tr("A few key poses become a motion that is put together from "
                                      "the takes and clips: it appears here."));
    for (auto* button : empty_->findChildren<QPushButton*>())
        button->setVisible(!why.isEmpty());
    tools_->setCurrentIndex(hit_.isOn() ? 1 : 0);
    setCurrentWidget(keys_.library() == nullptr ? empty_ : full_);
}

}  // namespace kumite::studio
