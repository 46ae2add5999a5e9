#include "studio/app/workspaces.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/icons.h"
#include "studio/app/theme.h"

namespace kumite::studio {

namespace {

/// Percent of text size: all names; that of the shown workspace alone.
constexpr int kNamesUpTo = 125;
constexpr int kNameUpTo = 150;

/// Large names leave no room for the menus: then the chosen tab alone, or none, has its name.
Qt::ToolButtonStyle styleOf(bool chosen, bool compact) {
    const bool named = textSize() <= (chosen ? kNameUpTo : kNamesUpTo) && (chosen || !compact);
    return named ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
}

}  // namespace

Workspaces::Workspaces(CommandTable& commands, QStackedWidget* panels, QStackedWidget* centres,
                       QObject* parent)
    : QObject(parent), commands_(commands), panels_(panels), centres_(centres) {
    centres_->hide();
}

void Workspaces::add(Workspace workspace) {
    // What large text makes too high is scrolled.
    auto* scroll = new QScrollArea(panels_);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(workspace.panel);
    scroll->setMinimumWidth(workspace.panel->minimumWidth());
    panels_->addWidget(scroll);
    if (workspace.centre != nullptr) centres_->addWidget(workspace.centre);
    if (workspace.addCommands) commands_.addFor(workspace.id, workspace.addCommands);
    const QString id = workspace.id;
    all_.push_back(std::move(workspace));
    if (all_.size() == 1) {
        show(id);
    } else {
        Q_EMIT changed();
    }
}

void Workspaces::addSwitchCommands(const QString& menu) {
    if (all_.size() < 2) return;
    for (std::size_t i = 0; i < all_.size(); ++i) {
        const QString id = all_[i].id;
        commands_.add({QStringLiteral("workspace.%1").arg(id),
                       i == 0 ? QLatin1Char('-') + menu : menu,
                       tr("%1 workspace").arg(all_[i].name),
                       {QKeySequence(QStringLiteral("Ctrl+%1").arg(i + 1))},
                       [this, id] { show(id); },
                       {},
                       [this, id] { return current_ == id; }});
    }
}

void Workspaces::show(const QString& id) {
    const auto found = std::find_if(all_.begin(), all_.end(),
                                    [&](const Workspace& each) { return each.id == id; });
    if (found == all_.end() || current_ == id) return;
    current_ = id;
    panels_->setCurrentIndex(static_cast<int>(found - all_.begin()));
    if (found->centre != nullptr) centres_->setCurrentWidget(found->centre);
    centres_->setVisible(found->centre != nullptr);
    commands_.showWorkspace(id);
    Q_EMIT changed();
}

WorkspaceBar::WorkspaceBar(Workspaces& workspaces, QWidget* parent)
    : QWidget(parent), workspaces_(workspaces), row_(new QHBoxLayout(this)) {
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(2);
    setAccessibleName(tr("Workspaces"));
    connect(&workspaces_, &Workspaces::changed, this, &WorkspaceBar::refresh);
    fill();
}

void WorkspaceBar::setCompact(bool compact) {
    if (compact == compact_) return;
    compact_ = compact;
    refresh();
}

void WorkspaceBar::refresh() {
    // Tabs that are there stay: one of them may have the focus, or be in the middle of a click.
    const auto tabs = findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
    if (static_cast<std::size_t>(tabs.size()) != workspaces_.all().size()) return fill();
    const QColor colour = coloursFor(palette()).text;
    for (std::size_t i = 0; i < workspaces_.all().size(); ++i) {
        const Workspace& workspace = workspaces_.all()[i];
        QToolButton* tab = tabs[static_cast<qsizetype>(i)];
        const bool chosen = workspace.id == workspaces_.current();
        tab->setIcon(lineIcon(workspace.icon, colour));
        tab->setToolButtonStyle(styleOf(chosen, compact_));
        tab->setChecked(chosen);
    }
    int width = row_->spacing() * static_cast<int>(tabs.size() - 1);
    for (const QToolButton* tab : tabs)
        width += tab->sizeHint().width();
    setMaximumWidth(compact_ ? width : QWIDGETSIZE_MAX);
}

void WorkspaceBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
    if (event->type() == QEvent::FontChange) fill();
}

void WorkspaceBar::fill() {
    while (QLayoutItem* item = row_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->setParent(nullptr);
        item->widget()->deleteLater();  // the style may be going through all widgets
        delete item;
    }
    const Colours& c = coloursFor(palette());
    const bool single = workspaces_.all().size() == 1;
    for (const Workspace& workspace : workspaces_.all()) {
        if (single) {
            auto* icon = new QLabel(this);
            icon->setPixmap(linePixmap(workspace.icon, c.secondText, 16, devicePixelRatioF()));
            row_->addWidget(icon);
            auto* name = new QLabel(workspace.name, this);
            name->setProperty("role", "second");
            name->setToolTip(workspace.tip);
            name->setContentsMargins(2, 0, 6, 0);
            row_->addWidget(name);
            continue;
        }
        auto* button = new QToolButton(this);
        button->setText(workspace.name);
        button->setIcon(lineIcon(workspace.icon, c.text));
        button->setIconSize(QSize(16, 16) * textSize() / 100);
        const bool chosen = workspace.id == workspaces_.current();
        button->setToolButtonStyle(styleOf(chosen, compact_));
        button->setCheckable(true);
        button->setChecked(chosen);
        button->setProperty("role", "workspace");
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(tr("%1 workspace").arg(workspace.name));
        button->setToolTip(workspace.tip);
        connect(button, &QToolButton::clicked, this, [this, id = workspace.id] {
            workspaces_.show(id);
            refresh();  // a click on the one that is shown would switch its tab off
        });
        row_->addWidget(button);
    }
}

}  // namespace kumite::studio
