#include "studio/app/document_panel.h"

#include <QEvent>
#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/opening.h"
#include "studio/app/session.h"
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
    list->setFixedHeight(std::min(height, 160));
}

}  // namespace

DocumentPanel::DocumentPanel(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      takes_(new QListWidget(this)),
      fighters_(new QListWidget(this)),
      history_(new QListWidget(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 4, 4);
    layout->setSpacing(4);
    const auto section = [&](const QString& title, QListWidget* list) {
        auto* heading = new QLabel(title, this);
        heading->setProperty("role", "heading");
        heading->setContentsMargins(4, 0, 0, 0);
        layout->addWidget(heading);
        layout->addWidget(list);
        list->setAccessibleName(title);
        list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        list->setTextElideMode(Qt::ElideMiddle);
        list->setIconSize({10, 10});
    };
    section(tr("Takes"), takes_);
    layout->addSpacing(8);
    section(tr("Fighters"), fighters_);
    layout->addSpacing(8);
    section(tr("History"), history_);
    // What an edit did is told in full: there is room below, not beside.
    history_->setWordWrap(true);
    layout->setStretchFactor(history_, 1);
    setMinimumWidth(112);

    connect(takes_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!filling_ && row >= 0) session_.setTake(row);
    });
    connect(fighters_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!filling_ && row >= 0) session_.setActivePlayer(row);
    });
    connect(history_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!filling_ && row >= 0) session_.document().goToStep(static_cast<std::size_t>(row));
    });
    connect(&session_.document(), &Document::changed, this, &DocumentPanel::refresh,
            Qt::QueuedConnection);
    connect(&session_, &Session::takeChanged, this, &DocumentPanel::refresh);
    connect(&session_, &Session::activePlayerChanged, this, &DocumentPanel::showFighters);
}

void DocumentPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) refresh();
    QWidget::changeEvent(event);
}

void DocumentPanel::refresh() {
    showTakes();
    showFighters();
    showHistory();
}

void DocumentPanel::showTakes() {
    filling_ = true;
    takes_->clear();
    for (const Take& take : session_.document().project().takes) {
        auto* item = new QListWidgetItem(QString::fromStdString(take.name), takes_);
        item->setToolTip(item->text());
    }
    takes_->setCurrentRow(session_.take());
    fitHeight(takes_);
    filling_ = false;
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
        item->setToolTip(tr("%1: %2\n%3 Hz, %4 frames")
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
    history_->clear();
    const History& history = session_.document().history();
    if (session_.document().isOpen()) {
        const Colours& c = coloursFor(palette());
        for (std::size_t step = 0; step < history.steps().size(); ++step) {
            auto* item =
                new QListWidgetItem(QString::fromStdString(history.steps()[step].name), history_);
            item->setToolTip(item->text());
            if (step > history.position()) item->setForeground(mixed(c.secondText, c.panel, 0.4));
        }
        history_->setCurrentRow(static_cast<int>(history.position()));
        history_->scrollToItem(history_->currentItem());
    }
    filling_ = false;
}

}  // namespace kumite::studio
