#pragma once

#include <QAbstractListModel>
#include <QStyledItemDelegate>

#include <memory>

#include "core/synthesis/bout_tape.h"

namespace kumite::studio {

class BoutSession;

/// What a fighter could have done at a choice, the likeliest first.
class CandidatesModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit CandidatesModel(const BoutSession& bout, QObject* parent = nullptr);

    void show(std::shared_ptr<const BoutChoice> choice);
    const BoutChoice* choice() const { return choice_.get(); }
    const Option& at(int row) const {
        return choice_->options.options[static_cast<std::size_t>(row)];
    }
    bool isChosen(int row) const { return at(row).candidate.node == choice_->node; }
    /// Why a candidate could not be drawn; empty where it could.
    static QString barredText(Barred barred);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    const BoutSession& bout_;
    std::shared_ptr<const BoutChoice> choice_;
};

/// Two lines a candidate: its name and chance; label term, geometry term and product over bars.
class CandidatesDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    explicit CandidatesDelegate(const CandidatesModel& model, QObject* parent);
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const CandidatesModel& model_;
};

}  // namespace kumite::studio
