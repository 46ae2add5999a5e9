#include "studio/app/takes_list.h"

#include <QDropEvent>

#include "core/project/edits.h"
#include "studio/app/session.h"

namespace kumite::studio {

TakesList::TakesList(Session& session, QWidget* parent) : QListWidget(parent), session_(session) {
    setDragDropMode(QAbstractItemView::InternalMove);
    setEditTriggers(QAbstractItemView::DoubleClicked);
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!filling_ && row >= 0) session_.setTake(row);
    });
    connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!filling_) rename(item);
    });
}

void TakesList::refresh() {
    filling_ = true;
    clear();
    for (const Take& take : session_.document().project().takes) {
        auto* item = new QListWidgetItem(QString::fromStdString(take.name), this);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(
            tr("%1\nDouble-click or F2 renames, Alt+↑ ↓ or a drag moves it.").arg(item->text()));
    }
    setCurrentRow(session_.take());
    filling_ = false;
}

void TakesList::renameShown() {
    if (QListWidgetItem* item = this->item(session_.take())) {
        setFocus();
        editItem(item);
    }
}

void TakesList::rename(QListWidgetItem* item) {
    const int take = row(item);
    const std::string name = item->text().trimmed().toStdString();
    session_.document().apply(
        [&](const Project& project) { return renameTake(project, take, name); });
    // A name that was refused, or spaces around it, must not stay. Not while the editor closes.
    QMetaObject::invokeMethod(this, &TakesList::refresh, Qt::QueuedConnection);
}

void TakesList::moveShown(int direction) {
    moveTo(session_.take(), session_.take() + direction);
}

void TakesList::moveTo(int take, int place) {
    if (place < 0 || place >= count()) return;
    session_.document().apply(
        [&](const Project& project) { return moveTake(project, take, place); });
}

int TakesList::placeAt(const QPoint& point) const {
    const QModelIndex under = indexAt(point);
    int before = count();
    if (under.isValid()) {
        before = under.row() + (point.y() > visualRect(under).center().y() ? 1 : 0);
    }
    return before > currentRow() ? before - 1 : before;
}

void TakesList::dropEvent(QDropEvent* event) {
    const int from = currentRow();
    if (event->source() != this || from < 0) {
        event->ignore();
        return;
    }
    // The list is filled anew from the project; the view must not move the row itself.
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    moveTo(from, placeAt(event->position().toPoint()));
}

}  // namespace kumite::studio
