#include "studio/app/document_panel.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/commands.h"
#include "studio/app/history_model.h"
#include "studio/app/opening.h"
#include "studio/app/panel_parts.h"
#include "studio/app/session.h"
#include "studio/app/takes_list.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

QPixmap swatch(const QColor& colour, double ratio) {
    QPixmap pixmap(QSize(10, 10) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(0, 0, 10, 10), 2.5, 2.5);
    return pixmap;
}

/// As high as its rows, so that short lists leave the room to the history.
void fitHeight(QListWidget* list) {
    int height = 2;
    for (int row = 0; row < list->count(); ++row)
        height += list->sizeHintForRow(row);
    list->setFixedHeight(std::min(height, withTextSize(160)));
}

}  // namespace

DocumentPanel::DocumentPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      takes_(new TakesList(session, this)),
      noTakes_(new QLabel(tr("Add recordings to begin a take."), this)),
      fighters_(new QListWidget(this)),
      history_(new QListView(this)),
      historyModel_(new HistoryModel(session.document(), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 4, 4);
    layout->setSpacing(4);
    takesHeading_ = addSection(tr("Takes"), takes_);
    noTakes_->setProperty("role", "second");
    noTakes_->setWordWrap(true);
    noTakes_->setContentsMargins(4, 0, 0, 0);
    layout->addWidget(noTakes_);
    layout->addSpacing(8);
    fightersHeading_ = addSection(tr("Fighters"), fighters_);
    layout->addSpacing(8);
    addSection(tr("History"), history_);
    for (QListWidget* list : {static_cast<QListWidget*>(takes_), fighters_}) {
        list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        list->setTextElideMode(Qt::ElideMiddle);
        list->setIconSize({10, 10});
    }
    history_->setObjectName(QStringLiteral("history"));
    history_->setModel(historyModel_);
    history_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    history_->setIconSize({10, 10});
    history_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    history_->setLayoutMode(QListView::Batched);
    history_->setResizeMode(QListView::Adjust);
    // What an edit did is told in full: there is room below, not beside.
    history_->setWordWrap(true);
    layout->setStretchFactor(history_, 1);
    setMinimumWidth(112);

    connect(fighters_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!filling_ && row >= 0) session_.setActivePlayer(row);
    });
    connect(history_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& now) {
                if (filling_ || !now.isValid()) return;
                session_.document().goToStep(static_cast<std::size_t>(now.row()));
            });
    connect(&session_.document(), &Document::changed, this, &DocumentPanel::refresh,
            Qt::QueuedConnection);
    connect(&session_, &Session::takeChanged, this, &DocumentPanel::refresh);
    connect(&session_, &Session::activePlayerChanged, this, &DocumentPanel::showFighters);
    refresh();
}

QHBoxLayout* DocumentPanel::addSection(const QString& title, QWidget* list) {
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    auto* heading = headingLabel(title, this);
    heading->setContentsMargins(4, 0, 0, 0);
    row->addWidget(heading);
    row->addStretch(1);
    auto* layout = static_cast<QVBoxLayout*>(this->layout());
    layout->addLayout(row);
    layout->addWidget(list);
    list->setAccessibleName(title);
    return row;
}

void DocumentPanel::addCommands(CommandTable& commands) {
    const auto addButton = [&](QHBoxLayout* row, const char* command) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(commands.action(QLatin1String(command)));
        button->setAccessibleName(commands.find(QLatin1String(command))->plainText());
        button->setIconSize({14, 14});
        button->setFocusPolicy(Qt::TabFocus);
        button->setProperty("role", "small");
        row->addWidget(button);
    };
    addButton(takesHeading_, "take.add");
    addButton(fightersHeading_, "fighter.swap");
    addButton(fightersHeading_, "fighter.properties");
    commands.offerMenu(
        takes_, {"take.add", "take.rename", "-", "take.up", "take.down", "-", "take.remove"});
    commands.offerMenu(fighters_, {"fighter.properties", "fighter.swap", "file.findRecording"});
    commands.offerMenu(history_, {"edit.undo", "edit.redo", "-", "file.save", "file.versions"});
    history_->viewport()->installEventFilter(this);
    connect(fighters_, &QListWidget::itemDoubleClicked,
            commands.action(QStringLiteral("fighter.properties")), &QAction::trigger);
}

bool DocumentPanel::eventFilter(QObject* watched, QEvent* event) {
    // A click goes back to a state; one that asks for the menu must not.
    const bool pressed = event->type() == QEvent::MouseButtonPress;
    if (pressed && static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton) return true;
    return QWidget::eventFilter(watched, event);
}

void DocumentPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

void DocumentPanel::refresh() {
    // Not under the hands of somebody who writes a name.
    if (!takes_->isRenaming()) {
        takes_->refresh();
        fitHeight(takes_);
    }
    noTakes_->setVisible(takes_->count() == 0);
    takes_->setVisible(takes_->count() > 0);
    showFighters();
    showHistory();
}

void DocumentPanel::showFighters() {
    filling_ = true;
    fighters_->clear();
    const Colours& c = coloursFor(palette());
    const auto& takes = session_.document().project().takes;
    for (int player = 0; player < session_.playerCount(); ++player) {
        const Fighter& fighter = takes[static_cast<std::size_t>(session_.take())]
                                     .fighters[static_cast<std::size_t>(player)];
        const QString path = fromPath(fighter.recording.path);
        QString text = QFileInfo(path).fileName();
        if (!fighter.motion) text += tr(" (missing)");
        auto* item = new QListWidgetItem(text, fighters_);
        // The same picture for selected rows: the colour is the fighter's name.
        const QPixmap colour = swatch(c.fighters[player], devicePixelRatioF());
        QIcon icon(colour);
        icon.addPixmap(colour, QIcon::Selected);
        item->setIcon(icon);
        item->setToolTip(tr("%1: %2\n%3 Hz, %4 frames\nDouble-click: start, place, floor, joints")
                             .arg(fighterText(player), path)
                             .arg(fighter.rate)
                             .arg(framesOf(fighter).size()));
    }
    fighters_->setCurrentRow(session_.activePlayer());
    fitHeight(fighters_);
    filling_ = false;
}

void DocumentPanel::showHistory() {
    filling_ = true;
    historyModel_->refresh(palette());
    const auto position = static_cast<int>(session_.document().history().position());
    history_->setCurrentIndex(historyModel_->index(position));
    history_->scrollTo(history_->currentIndex());
    filling_ = false;
}

}  // namespace kumite::studio
