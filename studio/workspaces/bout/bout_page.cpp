#include "studio/workspaces/bout/bout_page.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "studio/app/commands.h"
#include "studio/workspaces/bout/bout_panel.h"
#include "studio/workspaces/bout/bout_session.h"

namespace kumite::studio {

BoutPage::BoutPage(BoutSession& bout, QWidget* parent)
    : QStackedWidget(parent),
      bout_(bout),
      panel_(new BoutPanel(bout, this)),
      empty_(new QWidget(this)),
      why_(new QLabel(empty_)) {
    auto* layout = new QVBoxLayout(empty_);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    why_->setWordWrap(true);
    why_->setProperty("role", "second");
    why_->setAccessibleName(tr("Why there is no bout"));
    layout->addWidget(why_);
    layout->addStretch(1);
    addWidget(empty_);
    addWidget(panel_);
    connect(&bout_, &BoutSession::begun, this, &BoutPage::refresh);
    connect(&bout_, &BoutSession::stateChanged, this, &BoutPage::refresh);
    refresh();
}

void BoutPage::addCommands(CommandTable& commands) {
    const std::pair<const char*, QString> all[] = {
        {"bout.begin", tr("Anew")}, {"bout.keep", tr("Keep…")}, {"bout.export", tr("Export…")}};
    for (const auto& [id, text] : all) {
        const QAction* action = commands.action(QLatin1String(id));
        const QString name = commands.find(QLatin1String(id))->plainText();
        auto* button = new QPushButton(text, panel_);
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolTip(name);
        commands.tellKey(button, QLatin1String(id));
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        panel_->addButton(button);
    }
}

void BoutPage::addStep(const QString& text, const QString& tip, std::function<void()> run) {
    auto* button = new QPushButton(text, empty_);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, std::move(run));
    auto* layout = static_cast<QVBoxLayout*>(empty_->layout());
    layout->insertWidget(layout->count() - 1, button);
}

void BoutPage::refresh() {
    const QString why = bout_.whyNothing();
    const bool nothing = bout_.tape() == nullptr;
    why_->setText(!why.isEmpty() ? why
                                 : tr("A bout that goes on for ever, made from what was learnt of "
                                      "the labelled actions, appears here."));
    for (auto* button : empty_->findChildren<QPushButton*>())
        button->setVisible(!why.isEmpty());
    setCurrentWidget(nothing && !bout_.isPreparing() ? empty_ : static_cast<QWidget*>(panel_));
}

}  // namespace kumite::studio
