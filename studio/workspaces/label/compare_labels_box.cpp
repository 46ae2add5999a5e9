#include "studio/workspaces/label/compare_labels_box.h"

#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/core_words.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/label_session.h"

namespace kumite::studio {

DifferencesModel::DifferencesModel(LabelSession& labels, QObject* parent)
    : QAbstractTableModel(parent), labels_(labels) {}

void DifferencesModel::show(std::vector<Row> rows) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
}

void DifferencesModel::decide(int row, Decision decision) {
    rows_[static_cast<std::size_t>(row)].decision = decision;
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
}

int DifferencesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int DifferencesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString DifferencesModel::qualifierText(int aspect, int qualifier) const {
    if (qualifier == kUnknown) return QStringLiteral("–");
    const Aspect& of = labels_.vocabulary()[aspect];
    return vocabularyInText(of.qualifiers[static_cast<std::size_t>(qualifier)].name);
}

QVariant DifferencesModel::data(const QModelIndex& index, int role) const {
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const LabelDifference& difference = row.difference;
    if (difference.aspect >= labels_.vocabulary().size()) return {};
    const Colours& c = coloursFor(QGuiApplication::palette());
    const Project& project = labels_.session().document().project();
    const double seconds = timeOfFrame(fighterAt(project, difference.fighter), row.peak);
    const QString aspect = vocabularyInText(labels_.vocabulary()[difference.aspect].name);
    const QString mine = qualifierText(difference.aspect, difference.first);
    const QString theirs = qualifierText(difference.aspect, difference.second);
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == TimeColumn) return timeText(seconds, 0.1);
            if (index.column() == AspectColumn) return aspect;
            return index.column() == MineColumn ? mine : theirs;
        case Qt::ForegroundRole:
            if (index.column() == TimeColumn) return c.fighterText[difference.fighter.player];
            if (row.decision == Decision::Open) return c.text;
            return (index.column() == MineColumn) == (row.decision == Decision::Mine)
                       ? c.text
                       : c.secondText;
        case Qt::FontRole: {
            QFont font;
            const bool dropped =
                (index.column() == MineColumn && row.decision == Decision::Theirs) ||
                (index.column() == TheirsColumn && row.decision == Decision::Mine);
            font.setStrikeOut(dropped);
            return font;
        }
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return tr("%1, %2, %3: mine %4, theirs %5")
                .arg(timeText(seconds), fighterText(difference.fighter.player), aspect, mine,
                     theirs);
        default:
            return {};
    }
}

QVariant DifferencesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft);
    if (role != Qt::DisplayRole) return {};
    const QString names[] = {tr("time"), tr("aspect"), tr("mine"), tr("theirs")};
    return names[section];
}

CompareLabelsBox::CompareLabelsBox(LabelSession& labels, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      sentence_(new QLabel(this)),
      aspects_(new QTableWidget(0, 4, this)),
      model_(new DifferencesModel(labels, this)),
      table_(new QTableView(this)),
      theirsButton_(new QPushButton(tr("Take theirs"), this)),
      mineButton_(new QPushButton(tr("Keep mine"), this)),
      allButton_(new QPushButton(this)),
      addButton_(new QPushButton(this)),
      closeButton_(new QPushButton(tr("Close"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(sentence_);
    layout->addWidget(aspects_);
    layout->addWidget(table_, 1);
    auto* buttons = new QGridLayout;
    buttons->setSpacing(4);
    buttons->addWidget(theirsButton_, 0, 0);
    buttons->addWidget(mineButton_, 0, 1);
    buttons->addWidget(allButton_, 1, 0);
    buttons->addWidget(closeButton_, 1, 1);
    buttons->addWidget(addButton_, 2, 0, 1, 2);
    layout->addLayout(buttons);
    sentence_->setWordWrap(true);
    sentence_->setAlignment(Qt::AlignTop);
    sentence_->setProperty("role", "second");
    aspects_->setHorizontalHeaderLabels({tr("aspect"), tr("both"), tr("same"), tr("κ")});
    aspects_->setAccessibleName(tr("Agreement per aspect"));
    aspects_->setToolTip(
        tr("Both: actions of which both people said something. κ (Cohen): how much more often they "
           "say the same than by chance; 1 always, 0 as often as by chance."));
    table_->setModel(model_);
    table_->setAccessibleName(tr("Differences"));
    table_->setTabKeyNavigation(false);
    table_->setWordWrap(false);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    aspects_->setSelectionMode(QAbstractItemView::NoSelection);
    aspects_->setFocusPolicy(Qt::NoFocus);
    aspects_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    for (QTableView* table : {static_cast<QTableView*>(aspects_), table_}) {
        table->setShowGrid(false);
        table->setSelectionBehavior(QAbstractItemView::SelectRows);
        table->verticalHeader()->hide();
        table->verticalHeader()->setDefaultSectionSize(20);
        table->horizontalHeader()->setHighlightSections(false);
        table->horizontalHeader()->setMinimumSectionSize(28);
        table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    }
    aspects_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft);
    const QFontMetrics metrics = fontMetrics();
    const auto fix = [&](QTableView* table, int column, const QString& widest) {
        table->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Fixed);
        table->horizontalHeader()->resizeSection(column, metrics.horizontalAdvance(widest) + 12);
    };
    fix(table_, DifferencesModel::TimeColumn, QStringLiteral("00:00.0"));
    fix(aspects_, 1, tr("both"));
    fix(aspects_, 2, QStringLiteral("100 % 0"));
    fix(aspects_, 3, QStringLiteral("0.00"));
    theirsButton_->setToolTip(tr("Their value, as said by a hand; goes on to the next (Enter)"));
    mineButton_->setToolTip(tr("What the project says stays; goes on to the next (Backspace)"));
    allButton_->setToolTip(tr("Theirs for all that are not decided, as one step of the history"));
    addButton_->setToolTip(tr("Their labels where you have none, as said by a hand, in one step"));
    connect(addButton_, &QPushButton::clicked, this, &CompareLabelsBox::addOnlyTheirs);
    connect(theirsButton_, &QPushButton::clicked, this, &CompareLabelsBox::takeTheirs);
    connect(mineButton_, &QPushButton::clicked, this, &CompareLabelsBox::keepMine);
    connect(allButton_, &QPushButton::clicked, this, &CompareLabelsBox::takeAllTheirs);
    connect(closeButton_, &QPushButton::clicked, this, &CompareLabelsBox::close);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& row) { goToRow(row.row()); });
    connect(&labels_, &LabelSession::changed, this, &CompareLabelsBox::follow);
    connect(&labels_.session().document(), &Document::opened, this, &CompareLabelsBox::close);
    fillTable();
}

QWidget* CompareLabelsBox::list() const {
    return table_;
}

void CompareLabelsBox::compare(const QString& name, const MatchedLabels& theirs) {
    name_ = name;
    theirs_ = theirs;
    model_->show({});
    follow();
    step(1);
    Q_EMIT changed();
}

void CompareLabelsBox::close() {
    if (!theirs_) return;
    theirs_.reset();
    agreement_.reset();
    model_->show({});
    fillTable();
    Q_EMIT changed();
}

/// Compares anew after every edit; what was decided stays in the list.
void CompareLabelsBox::follow() {
    const Document& document = labels_.session().document();
    if (!theirs_ || !document.isCurrent()) return;
    const Project& project = document.project();
    const Analysis& analysis = document.analysis();
    try {
        agreement_ =
            compareLabels(project, analysis, ownLabels(project, analysis), theirs_->fighters);
    } catch (const Error&) {
        // Boundaries moved: their labels must be brought to the actions anew.
        Q_EMIT labels_.session().hinted(
            tr("The boundaries have changed. Open %1 once more to compare.").arg(name_));
        return close();
    }
    using Row = DifferencesModel::Row;
    std::vector<Row> rows = model_->rows();
    const auto same = [](const LabelDifference& a, const LabelDifference& b) {
        return a.fighter == b.fighter && a.action == b.action && a.aspect == b.aspect;
    };
    for (Row& row : rows) {
        const bool differs =
            std::any_of(agreement_->differences.begin(), agreement_->differences.end(),
                        [&](const LabelDifference& each) { return same(each, row.difference); });
        if (row.decision == DifferencesModel::Decision::Theirs && differs)
            row.decision = DifferencesModel::Decision::Open;  // undone
        if (row.decision == DifferencesModel::Decision::Open && !differs)
            row.decision = DifferencesModel::Decision::Theirs;
    }
    for (const LabelDifference& each : agreement_->differences) {
        const bool listed = std::any_of(rows.begin(), rows.end(),
                                        [&](const Row& row) { return same(row.difference, each); });
        if (listed || each.second == kUnknown) continue;
        const Action& action =
            analysis.at(each.fighter).segmentation->actions[static_cast<std::size_t>(each.action)];
        rows.push_back({each, action.peak, DifferencesModel::Decision::Open});
    }
    choosing_ = true;
    const int row = current();
    model_->show(std::move(rows));
    if (row >= 0) table_->selectRow(row);
    choosing_ = false;
    fillTable();
}

void CompareLabelsBox::fillTable() {
    aspects_->setRowCount(0);
    const Vocabulary& vocabulary = labels_.vocabulary();
    for (int a = 0; agreement_ && a < static_cast<int>(agreement_->aspects.size()); ++a) {
        const AspectAgreement& aspect = agreement_->aspects[static_cast<std::size_t>(a)];
        if (aspect.both == 0) continue;
        const int row = aspects_->rowCount();
        aspects_->insertRow(row);
        const QString texts[] = {vocabularyWords(vocabulary[a].name), QString::number(aspect.both),
                                 percentText(static_cast<double>(aspect.same) / aspect.both),
                                 aspect.kappa ? numberText(*aspect.kappa, 2) : QStringLiteral("–")};
        for (int column = 0; column < 4; ++column)
            aspects_->setItem(row, column, new QTableWidgetItem(texts[column]));
    }
    aspects_->setVisible(aspects_->rowCount() > 0);
    aspects_->setFixedHeight(aspects_->horizontalHeader()->sizeHint().height() +
                             20 * aspects_->rowCount() + 2);
    showButtons();
}

void CompareLabelsBox::showButtons() {
    int open = 0;
    for (const auto& row : model_->rows())
        open += row.decision == DifferencesModel::Decision::Open;
    if (!agreement_) {
        sentence_->setText(
            tr("Another person's labels are compared here with those of the "
               "project: Label > Compare with labels of… opens their file."));
    } else {
        QString text = (agreement_->both == 1 ? tr("%1: 1 action labelled by both, %2 alike")
                                              : tr("%1: %3 actions labelled by both, %2 alike"))
                           .arg(name_)
                           .arg(agreement_->same);
        if (agreement_->both != 1) text = text.arg(agreement_->both);
        if (agreement_->kappa) text += tr(", κ %1").arg(numberText(*agreement_->kappa, 2));
        text += open == 0   ? tr(". No difference to decide.")
                : open == 1 ? tr(". 1 difference to decide.")
                            : tr(". %1 differences to decide.").arg(open);
        if (agreement_->onlyFirst > 0)
            text += tr(" Only you labelled %1 more.").arg(agreement_->onlyFirst);
        sentence_->setText(text);
    }
    table_->setVisible(agreement_.has_value());
    for (QPushButton* button : {theirsButton_, mineButton_, allButton_, closeButton_})
        button->setVisible(agreement_.has_value());
    const bool any = current() >= 0;
    theirsButton_->setEnabled(any);
    mineButton_->setEnabled(any);
    allButton_->setText(tr("Theirs for all %1").arg(open));
    allButton_->setEnabled(open > 0);
    const int only = agreement_ ? agreement_->onlySecond : 0;
    addButton_->setVisible(only > 0);
    addButton_->setText(only == 1 ? tr("Add the 1 that only they labelled")
                                  : tr("Add the %1 that only they labelled").arg(only));
}

int CompareLabelsBox::current() const {
    const QModelIndex index = table_->currentIndex();
    return index.isValid() && index.row() < model_->rowCount() ? index.row() : -1;
}

void CompareLabelsBox::goToRow(int row) {
    if (choosing_ || row < 0 || row >= model_->rowCount()) return;
    const auto& chosen = model_->rows()[static_cast<std::size_t>(row)];
    const int index = labels_.indexOf(chosen.difference.fighter, chosen.peak);
    if (index < 0) return;
    labels_.goTo(labels_.actions()[static_cast<std::size_t>(index)]);
    labels_.setAspect(chosen.difference.aspect);
    labels_.session().transport().setPlaying(true);
    showButtons();
}

void CompareLabelsBox::step(int direction) {
    const int count = model_->rowCount();
    const int from = current() < 0 ? (direction > 0 ? -1 : 0) : current();
    for (int i = 1; i <= count; ++i) {
        const int row = ((from + direction * i) % count + count) % count;
        if (model_->rows()[static_cast<std::size_t>(row)].decision !=
            DifferencesModel::Decision::Open)
            continue;
        table_->selectRow(row);
        table_->scrollTo(model_->index(row, 0));
        return;
    }
    showButtons();
}

void CompareLabelsBox::takeTheirs() {
    const int row = current();
    if (row < 0) return;
    const std::vector<LabelDifference> one = {
        model_->rows()[static_cast<std::size_t>(row)].difference};
    model_->decide(row, DifferencesModel::Decision::Theirs);
    labels_.session().document().apply(
        Document::BoundaryEdit([&](const Project& project, const Analysis& analysis) {
            return takeOverLabels(project, analysis, one);
        }));
    step(1);
}

void CompareLabelsBox::keepMine() {
    const int row = current();
    if (row < 0) return;
    model_->decide(row, DifferencesModel::Decision::Mine);
    showButtons();
    step(1);
}

void CompareLabelsBox::addOnlyTheirs() {
    if (!agreement_) return;
    labels_.session().document().apply(
        Document::BoundaryEdit([&](const Project& project, const Analysis& analysis) {
            return takeOverLabels(project, analysis, agreement_->additions);
        }));
}

void CompareLabelsBox::takeAllTheirs() {
    std::vector<LabelDifference> open;
    for (const auto& row : model_->rows()) {
        if (row.decision == DifferencesModel::Decision::Open) open.push_back(row.difference);
    }
    labels_.session().document().apply(
        Document::BoundaryEdit([&](const Project& project, const Analysis& analysis) {
            return takeOverLabels(project, analysis, open);
        }));
}

}  // namespace kumite::studio
