#pragma once

#include <QAbstractListModel>
#include <QColor>
#include <QPalette>

namespace kumite::studio {

class Document;

/// The steps of the open project's history: what was done, what was undone, where it stands and
/// which step the file holds.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit HistoryModel(const Document& document, QObject* parent = nullptr);

    /// Reads the history anew; `palette` gives the colours.
    void refresh(const QPalette& palette);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    const Document& document_;
    QColor undone_;
    QColor mark_;
    int rows_ = 0;
};

}  // namespace kumite::studio
