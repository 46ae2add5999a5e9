#include "studio/workspaces/sequence/actions_model.h"

#include <QMimeData>

#include <algorithm>

#include "studio/app/words.h"
#include "studio/workspaces/sequence/sequence_session.h"

namespace kumite::studio {

ActionsModel::ActionsModel(const SequenceSession& sequence, QObject* parent)
    : QAbstractTableModel(parent), sequence_(sequence) {}

void ActionsModel::setFilter(const QString& words) {
    words_ = words.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    refresh();
}

void ActionsModel::refresh() {
    beginResetModel();
    shown_.clear();
    const MotionLibrary* library = sequence_.library();
    const std::size_t count = library != nullptr ? library->actions.size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const LibraryAction& action = library->actions[i];
        const QString text =
            (sequence_.titleOf(action) + QLatin1Char(' ') + QString::fromStdString(action.name))
                .toLower();
        if (std::all_of(words_.begin(), words_.end(),
                        [&](const QString& word) { return text.contains(word); }))
            shown_.push_back(static_cast<int>(i));
    }
    endResetModel();
}

const LibraryAction& ActionsModel::at(int row) const {
    return sequence_.library()
        ->actions[static_cast<std::size_t>(shown_[static_cast<std::size_t>(row)])];
}

int ActionsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int ActionsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 3;
}

QVariant ActionsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || sequence_.library() == nullptr) return {};
    const LibraryAction& action = at(index.row());
    const MotionLibrary& library = *sequence_.library();
    const double begin = action.frames.begin / library.rate;
    const QString place =
        QString::fromStdString(library.motions[static_cast<std::size_t>(action.motion)].name);
    if (role == Qt::TextAlignmentRole && index.column() == SecondsColumn)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole) {
        return tr("%1, %2 from %3\nReturn adds it, Shift+Return swaps it for the chosen block")
            .arg(sequence_.titleOf(action), place, timeText(begin));
    }
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case TitleColumn:
            return sequence_.titleOf(action);
        case PlaceColumn: {
            const bool whole =
                action.name == library.motions[static_cast<std::size_t>(action.motion)].name;
            // Where there is one take its name says nothing.
            const auto colon = place.lastIndexOf(QLatin1Char(':'));
            const bool brief = sequence_.takeCount() == 1 && colon >= 0;
            return whole ? QString()
                         : QStringLiteral("%1  %2").arg(brief ? place.mid(colon + 1) : place,
                                                        timeText(begin, 1));
        }
        default:
            return numberText(action.frames.size() / library.rate, 1);
    }
}

Qt::ItemFlags ActionsModel::flags(const QModelIndex& index) const {
    return QAbstractTableModel::flags(index) | Qt::ItemIsDragEnabled;
}

QMimeData* ActionsModel::mimeData(const QModelIndexList& indexes) const {
    auto* data = new QMimeData;
    if (!indexes.isEmpty())
        data->setData(QLatin1String(kMimeType),
                      QByteArray::fromStdString(at(indexes.front().row()).name));
    return data;
}

QVariant ActionsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return int(section == SecondsColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
    if (role != Qt::DisplayRole) return {};
    const QString texts[] = {tr("action"), tr("where"), tr("s")};
    return texts[section];
}

}  // namespace kumite::studio
