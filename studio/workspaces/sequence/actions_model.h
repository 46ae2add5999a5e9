#pragma once

#include <QAbstractTableModel>

#include <vector>

#include "core/motion/motion_library.h"

namespace kumite::studio {

class SequenceSession;

/// The actions that a sequence can be made of: what each is, where it is from, how long it is.
/// Shows those in which every word that is looked for appears.
class ActionsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// What is dragged: an action's name, UTF-8.
    static constexpr const char* kMimeType = "application/x-kumite-action";

    enum Column { TitleColumn, PlaceColumn, SecondsColumn };

    explicit ActionsModel(const SequenceSession& sequence, QObject* parent = nullptr);

    void setFilter(const QString& words);
    void refresh();
    const LibraryAction& at(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override { return {QLatin1String(kMimeType)}; }
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const SequenceSession& sequence_;
    QStringList words_;
    std::vector<int> shown_;  ///< indices of the library's actions
};

}  // namespace kumite::studio
