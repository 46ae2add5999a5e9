#include "studio/workspaces/bout/candidates_model.h"

#include "studio/app/candidate_row.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/workspaces/bout/bout_session.h"

namespace kumite::studio {

CandidatesModel::CandidatesModel(const BoutSession& bout, QObject* parent)
    : QAbstractListModel(parent), bout_(bout) {}

void CandidatesModel::show(std::shared_ptr<const BoutChoice> choice) {
    beginResetModel();
    choice_ = std::move(choice);
    endResetModel();
}

QString CandidatesModel::barredText(Barred barred) {
    switch (barred) {
        case Barred::No:
            break;
        case Barred::NoSample:
            return tr("no example");
        case Barred::Mode:
            return tr("not in this mode");
        case Barred::Command:
            return tr("not asked for");
        case Barred::Stance:
            return tr("other stance");
        case Barred::Ban:
            return tr("banned");
    }
    return {};
}

int CandidatesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !choice_ ? 0 : static_cast<int>(choice_->options.options.size());
}

QVariant CandidatesModel::data(const QModelIndex& index, int role) const {
    const Option& option = at(index.row());
    const QString name = bout_.nameOf(choice_->player, option.candidate.node);
    if (role == Qt::DisplayRole) return name;
    if (role != Qt::ToolTipRole && role != Qt::AccessibleTextRole) return {};
    QString text =
        tr("%1: chance %2, label term %3, geometry term %4, product %5")
            .arg(name, numberText(option.chance, 3), numberText(option.candidate.label, 3),
                 numberText(option.candidate.geometry, 3), numberText(option.candidate.product, 3));
    if (option.candidate.transition >= 0) {
        const CoupledGraph& graph = *bout_.library().graph;
        const Transition& t = graph.transitionsOf(
            choice_->player)[static_cast<std::size_t>(option.candidate.transition)];
        const BasicAction& sample = graph.action(choice_->player, t.next);
        text += tr("\nSample: %1, %2")
                    .arg(QString::fromStdString(graph.takes[static_cast<std::size_t>(sample.take)]),
                         timeText(sample.beginSeconds));
    }
    if (option.barred != Barred::No)
        text += tr("\nCould not be drawn: %1").arg(barredText(option.barred));
    text += isChosen(index.row()) ? tr("\nThis was chosen") : tr("\nA click takes it instead");
    return text;
}

CandidatesDelegate::CandidatesDelegate(const CandidatesModel& model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

QSize CandidatesDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return candidateRowSize(option);
}

void CandidatesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
    const Option& drawn = model_.at(index.row());
    const ChoiceModel::Candidate& candidate = drawn.candidate;
    CandidateRow row;
    row.name = index.data().toString();
    row.isFaint = drawn.barred != Barred::No;
    row.chance = row.isFaint ? CandidatesModel::barredText(drawn.barred)
                             : tr("P %1").arg(chanceText(drawn.chance));
    row.isTaken = model_.isChosen(index.row());
    row.colour = coloursFor(option.palette).fighters[model_.choice()->player];
    // Three stand side by side: what is hardly there is told by a word less.
    const auto number = [](double p) {
        return p < 0.005 ? QStringLiteral("~0") : numberText(p, 2);
    };
    row.bars = {{tr("label %1").arg(number(candidate.label)), candidate.label},
                {tr("geom. %1").arg(number(candidate.geometry)), candidate.geometry},
                {tr("both %1").arg(number(candidate.product)), candidate.product}};
    paintCandidateRow(*painter, option, row);
}

}  // namespace kumite::studio
