#include "studio/workspaces/graph/matrix_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/workspaces/graph/chooser_row.h"
#include "studio/workspaces/graph/matrix_view.h"

namespace kumite::studio {

namespace {

QString chanceText(double p) {
    return numberText(p, p < 0.0995 ? 3 : 2);
}

}  // namespace

MatrixPage::MatrixPage(GraphSession& graph, QWidget* parent)
    : QWidget(parent),
      graph_(graph),
      rows_(new QComboBox(this)),
      sort_(new QComboBox(this)),
      values_(new QComboBox(this)),
      how_(new QComboBox(this)),
      logarithmic_(new QCheckBox(tr("log"), this)) {
    rows_->addItems({tr("by own label"), tr("by opponent's label"), tr("by both labels")});
    rows_->setAccessibleName(tr("What the rows know"));
    rows_->setToolTip(
        tr("What the rows know: what the fighter does, what the opponent does, or "
           "both. What is left out is summed over."));
    sort_->addItems({tr("by count"), tr("by name"), tr("by likeness")});
    sort_->setAccessibleName(tr("Order of rows and columns"));
    sort_->setToolTip(
        tr("By likeness rows that lead to the same labels become neighbours; a line "
           "parts the groups."));
    values_->addItems({tr("P, EQU7"), tr("P, EQU6"), tr("P, EQU5"), tr("as counted")});
    values_->setAccessibleName(tr("How probabilities are estimated"));
    values_->setToolTip(
        tr("EQU7: P(next | own) · P(next | opponent). EQU6: over pairs of label elements. EQU5: "
           "counts of whole triples. All three with a prior, so that nothing is impossible; as "
           "counted: without."));
    how_->addItems({tr("side by side"), tr("difference")});
    how_->setAccessibleName(tr("How two are compared"));
    logarithmic_->setToolTip(tr("Colours over the logarithm: rare transitions become visible"));
    layOut();
    for (QComboBox* box : {rows_, sort_, how_})
        connect(box, &QComboBox::currentIndexChanged, this, &MatrixPage::refresh);
    connect(values_, &QComboBox::currentIndexChanged, this, [this](int index) {
        constexpr LabelEstimator kEstimators[] = {LabelEstimator::Equ7, LabelEstimator::Equ6,
                                                  LabelEstimator::Equ5};
        if (index < 3) {
            GraphOptions options = graph_.options();
            options.estimator = kEstimators[index];
            graph_.setOptions(options);
        }
        refresh();
    });
    connect(logarithmic_, &QCheckBox::toggled, this, &MatrixPage::refresh);
    connect(&graph_, &GraphSession::valuesChanged, this, &MatrixPage::refresh);
    connect(&graph_, &GraphSession::optionsChanged, this, &MatrixPage::refresh);
    connect(&graph_, &GraphSession::selectionChanged, this, &MatrixPage::showSelection);
    connect(&graph_, &GraphSession::momentChanged, this, &MatrixPage::showMoment);
    refresh();
}

void MatrixPage::layOut() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    FlowRow* row = addChooserRow(*layout);
    for (QComboBox* box : {rows_, sort_, values_, how_}) {
        box->setFocusPolicy(Qt::TabFocus);
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->setMinimumContentsLength(8);
        row->addWidget(box);
    }
    row->addWidget(logarithmic_);
    auto* matrices = new QHBoxLayout;
    matrices->setSpacing(1);
    for (const int number : {0, 1}) {
        auto* view = new MatrixView(this);
        views_[static_cast<std::size_t>(number)] = view;
        matrices->addWidget(view, 1);
        connect(view, &MatrixView::placeChosen, this,
                [this, number](const MatrixPlace& place) { choose(number, place); });
        connect(view, &MatrixView::placeActivated, this,
                [this](const MatrixPlace&) { graph_.playNext(); });
        connect(view, &MatrixView::placeHovered, this,
                [this, number](const auto& place) { tell(number, place); });
    }
    views_[1]->setAccessibleName(tr("Matrix of transitions to compare with"));
    // Both show the same part.
    for (const int number : {0, 1}) {
        MatrixView* from = views_[static_cast<std::size_t>(number)];
        MatrixView* to = views_[static_cast<std::size_t>(1 - number)];
        connect(from->verticalScrollBar(), &QScrollBar::valueChanged, to->verticalScrollBar(),
                &QScrollBar::setValue);
        connect(from->horizontalScrollBar(), &QScrollBar::valueChanged, to->horizontalScrollBar(),
                &QScrollBar::setValue);
    }
    layout->addLayout(matrices, 1);
}

void MatrixPage::setRows(TableRows rows) {
    rows_->setCurrentIndex(static_cast<int>(rows));
}

void MatrixPage::setSort(MatrixSort sort) {
    sort_->setCurrentIndex(static_cast<int>(sort));
}

void MatrixPage::setDifference(bool difference) {
    how_->setCurrentIndex(difference ? 1 : 0);
}

MatrixPage::Side MatrixPage::sideOf(int number) const {
    Side side{graph_.sides()[static_cast<std::size_t>(number)], {}};
    const auto kind = static_cast<TableRows>(rows_->currentIndex());
    const bool counted = values_->currentIndex() == 3;
    side.table = counted ? countedTable(side.graph(), side.mover, kind)
                         : transitionTable(side.graph(), side.mover, side.model().labels, kind);
    return side;
}

QString MatrixPage::rowName(const TablePairing::Place& place) const {
    const Side& side = sides_[place.first >= 0 ? 0 : 1];
    const auto& row =
        side.table.rows[static_cast<std::size_t>(place.first >= 0 ? place.first : place.second)];
    const Vocabulary& words = *side.graph().vocabulary;
    QStringList parts;
    if (row.own != kAnyNode) {
        parts.append(shortLabelWords(words, side.graph().node(side.mover, row.own).label));
    }
    if (row.opponent != kAnyNode) {
        parts.append(shortLabelWords(words, side.graph().node(1 - side.mover, row.opponent).label));
    }
    return parts.join(QStringLiteral(" | "));
}

QString MatrixPage::columnName(const TablePairing::Place& place) const {
    const Side& side = sides_[place.first >= 0 ? 0 : 1];
    const int node = place.first >= 0 ? place.first : place.second;
    return shortLabelWords(*side.graph().vocabulary, side.graph().node(side.mover, node).label);
}

MatrixTable MatrixPage::tableOf(int number) const {
    const Side& side = sides_[static_cast<std::size_t>(number)];
    MatrixTable table;
    const auto rows = static_cast<Eigen::Index>(pairing_.rows.size());
    const auto columns = static_cast<Eigen::Index>(pairing_.columns.size());
    table.values = Eigen::MatrixXd::Zero(rows, columns);
    table.counts = Eigen::MatrixXi::Zero(rows, columns);
    const auto at = [number](const TablePairing::Place& place) {
        return number == 0 ? place.first : place.second;
    };
    for (const auto& place : pairing_.rows) {
        const int row = at(place);
        table.rows.push_back(
            {rowName(place), row >= 0 ? side.table.rows[static_cast<std::size_t>(row)].count : 0});
    }
    for (const auto& place : pairing_.columns) {
        const int column = at(place);
        table.columns.push_back(
            {columnName(place), column >= 0 ? side.table.counts.col(column).sum() : 0});
    }
    for (Eigen::Index r = 0; r < rows; ++r) {
        const int row = at(pairing_.rows[static_cast<std::size_t>(r)]);
        for (Eigen::Index c = 0; row >= 0 && c < columns; ++c) {
            const int column = at(pairing_.columns[static_cast<std::size_t>(c)]);
            if (column < 0) continue;
            table.values(r, c) = side.table.probabilities(row, column);
            table.counts(r, c) = side.table.counts(row, column);
        }
    }
    return table;
}

void MatrixPage::refresh() {
    if (!graph_.hasGraph()) return;
    const bool two = graph_.compares();
    how_->setVisible(two);
    shown_ = graph_.sharedValues();
    sides_[0] = sideOf(0);
    sides_[1] = two ? sideOf(1) : sides_[0];
    pairing_ = pairTables(sides_[0].graph(), sides_[0].mover, sides_[0].table, sides_[1].graph(),
                          sides_[1].mover, sides_[1].table);
    const Colours& c = coloursFor(palette());
    const QString given[] = {tr("P(next | own)"), tr("P(next | opponent)"),
                             tr("P(next | own, opponent)")};
    const QString& caption = given[rows_->currentIndex()];
    const auto sort = static_cast<MatrixSort>(sort_->currentIndex());
    MatrixTable first = tableOf(0);
    const bool difference = two && how_->currentIndex() == 1;
    logarithmic_->setEnabled(!difference);
    views_[1]->setVisible(two && !difference);
    if (difference) {
        const MatrixTable second = tableOf(1);
        first.values -= second.values;
        first.counts += second.counts;
        for (std::size_t i = 0; i < first.rows.size(); ++i)
            first.rows[i].count += second.rows[i].count;
        for (std::size_t i = 0; i < first.columns.size(); ++i)
            first.columns[i].count += second.columns[i].count;
        first.isDifference = true;
        const double top = std::max(0.05, first.values.cwiseAbs().maxCoeff());
        views_[0]->show(first, orderOf(first, sort), differenceScale(c, top),
                        tr("%1 − %2").arg(sides_[0].name, sides_[1].name));
    } else {
        const MatrixOrder order = orderOf(first, sort);
        const bool log = logarithmic_->isChecked();
        // Both on one scale, or they could not be compared.
        const double top = scaleTop(std::max(sides_[0].table.probabilities.maxCoeff(),
                                             sides_[1].table.probabilities.maxCoeff()));
        const auto captionOf = [&](int number) {
            return two ? tr("%1: %2").arg(sides_[static_cast<std::size_t>(number)].name, caption)
                       : caption;
        };
        if (two) {
            views_[1]->show(tableOf(1), order, probabilityScale(c, sides_[1].mover, log, top),
                            captionOf(1));
        }
        views_[0]->show(std::move(first), order, probabilityScale(c, sides_[0].mover, log, top),
                        captionOf(0));
    }
    showSelection();
    showMoment();
}

std::optional<TransitionFilter> MatrixPage::filterOf(int number, const MatrixPlace& place) const {
    const auto at = [number](const TablePairing::Place& pair) {
        return number == 0 ? pair.first : pair.second;
    };
    TransitionFilter filter;
    if (place.row >= 0) {
        const int row = at(pairing_.rows[static_cast<std::size_t>(place.row)]);
        if (row < 0) return std::nullopt;
        const auto& found =
            sides_[static_cast<std::size_t>(number)].table.rows[static_cast<std::size_t>(row)];
        filter.own = found.own;
        filter.opponent = found.opponent;
    }
    if (place.column >= 0) {
        filter.next = at(pairing_.columns[static_cast<std::size_t>(place.column)]);
        if (filter.next < 0) return std::nullopt;
    }
    return filter;
}

std::optional<MatrixPlace> MatrixPage::placeOf(int number, const TransitionFilter& filter) const {
    const Side& side = sides_[static_cast<std::size_t>(number)];
    const auto at = [number](const TablePairing::Place& pair) {
        return number == 0 ? pair.first : pair.second;
    };
    const auto kind = static_cast<TableRows>(rows_->currentIndex());
    const int own = kind == TableRows::Opponent ? kAnyNode : filter.own;
    const int opponent = kind == TableRows::Own ? kAnyNode : filter.opponent;
    MatrixPlace place;
    const bool lacksRow = (kind != TableRows::Opponent && own == kAnyNode) ||
                          (kind != TableRows::Own && opponent == kAnyNode);
    for (std::size_t i = 0; !lacksRow && i < pairing_.rows.size(); ++i) {
        const int row = at(pairing_.rows[i]);
        if (row < 0) continue;
        const auto& found = side.table.rows[static_cast<std::size_t>(row)];
        if (found.own == own && found.opponent == opponent) place.row = static_cast<int>(i);
    }
    for (std::size_t i = 0; filter.next != kAnyNode && i < pairing_.columns.size(); ++i) {
        if (at(pairing_.columns[i]) == filter.next) place.column = static_cast<int>(i);
    }
    return place.row < 0 && place.column < 0 ? std::nullopt : std::optional(place);
}

void MatrixPage::showSelection() {
    const auto& selection = graph_.selection();
    for (const int number : {0, 1}) {
        const Side& side = sides_[static_cast<std::size_t>(number)];
        const bool own = selection && graph_.hasGraph() && side.mover == selection->mover &&
                         &side.graph() == &graph_.graph();
        views_[static_cast<std::size_t>(number)]->setChosen(own ? placeOf(number, selection->filter)
                                                                : std::nullopt);
    }
}

void MatrixPage::showMoment() {
    for (const int number : {0, 1}) {
        const Side& side = sides_[static_cast<std::size_t>(number)];
        std::optional<MatrixPlace> place;
        if (graph_.hasGraph() && &side.graph() == &graph_.graph()) {
            const GraphMoment& moment = graph_.moment(side.mover);
            place = placeOf(number, {moment.decision.own, moment.decision.opponent, moment.next});
        }
        views_[static_cast<std::size_t>(number)]->setNow(place);
    }
}

void MatrixPage::choose(int number, const MatrixPlace& place) {
    // What one side lacks the other may have.
    for (const int candidate : {number, 1 - number}) {
        const Side& side = sides_[static_cast<std::size_t>(candidate)];
        if (&side.graph() != &graph_.graph()) continue;
        if (const auto filter = filterOf(candidate, place)) {
            graph_.select(GraphSelection{side.mover, *filter});
            return;
        }
    }
    graph_.select(std::nullopt);
}

void MatrixPage::tell(int number, const std::optional<MatrixPlace>& place) {
    if (!place) {
        Q_EMIT graph_.session().hovered({});
        return;
    }
    const MatrixTable& table = views_[static_cast<std::size_t>(number)]->table();
    const auto line = [](const std::vector<MatrixTable::Line>& lines, int index) {
        return lines[static_cast<std::size_t>(index)];
    };
    QString text;
    if (place->isCell()) {
        const double value = table.values(place->row, place->column);
        const QString shown = table.isDifference ? tr("difference %1").arg(numberText(value, 3))
                                                 : tr("P %1").arg(chanceText(value));
        text = tr("%1 → %2   ·   %3   ·   seen %4 of %5 times")
                   .arg(line(table.rows, place->row).name, line(table.columns, place->column).name,
                        shown)
                   .arg(table.counts(place->row, place->column))
                   .arg(line(table.rows, place->row).count);
    } else if (place->row >= 0) {
        const auto row = line(table.rows, place->row);
        text = tr("%1   ·   %2 transitions begin so").arg(row.name).arg(row.count);
    } else {
        const auto column = line(table.columns, place->column);
        text = tr("%1   ·   %2 transitions lead here").arg(column.name).arg(column.count);
    }
    Q_EMIT graph_.session().hovered(text);
}

QSize MatrixPage::wholeSize() const {
    QSize size = views_[0]->wholeSize();
    if (!views_[1]->isHidden()) {
        const QSize other = views_[1]->wholeSize();
        size = {size.width() + 24 + other.width(), std::max(size.height(), other.height())};
    }
    return size;
}

void MatrixPage::paintWhole(QPainter& painter) const {
    const Colours& c = coloursFor(palette());
    painter.fillRect(QRect(QPoint(), wholeSize()), c.ground);
    views_[0]->paintWhole(painter, c);
    if (views_[1]->isHidden()) return;
    painter.translate(views_[0]->wholeSize().width() + 24, 0);
    views_[1]->paintWhole(painter, c);
}

void MatrixPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
}

}  // namespace kumite::studio
