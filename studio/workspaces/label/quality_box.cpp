#include "studio/workspaces/label/quality_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "studio/app/core_words.h"
#include "studio/app/session.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/found_list.h"
#include "studio/workspaces/label/label_session.h"
#include "studio/workspaces/label/label_words.h"
#include "studio/workspaces/label/learning_plot.h"

namespace kumite::studio {

namespace {

ConfusionTable tableOf(const Aspect& aspect, const AspectScore& score) {
    ConfusionTable table;
    for (const Qualifier& qualifier : aspect.qualifiers) {
        table.names.append(vocabularyInText(qualifier.name));
        table.spelt.append(QString::fromStdString(qualifier.id));
    }
    table.byRule = aspect.classifier != Classifier::Msvm;
    table.counts = score.confusion;
    return table;
}

QLabel* secondLine(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setProperty("role", "second");
    return label;
}

}  // namespace

QualityBox::QualityBox(LabelSession& labels, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      aspects_(new QComboBox(this)),
      accuracy_(secondLine(this)),
      matrix_(new ConfusionMatrix(this)),
      said_(secondLine(this)),
      list_(new FoundList(labels, tr("Actions of the cell"), this)),
      plot_(new LearningPlot(this)),
      gain_(secondLine(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(aspects_);
    layout->addWidget(accuracy_);
    layout->addWidget(matrix_);
    layout->addWidget(said_);
    layout->addWidget(list_, 4);
    layout->addWidget(plot_, 4);
    layout->addWidget(gain_);
    layout->addStretch(1);
    aspects_->setAccessibleName(tr("Aspect of the confusion matrix"));
    aspects_->setToolTip(tr("Whose classes the matrix and the list are about."));
    said_->setAccessibleName(tr("What the cell says"));
    // Two lines, so that nothing moves when the pointer does.
    said_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    said_->setAlignment(Qt::AlignTop);
    plot_->setMaximumHeight(220);
    plot_->setToolTip(
        tr("Share of actions whose learnt aspects are all right. Expected: cross-validation over "
           "the hand labels as the session went. As asked and random: the hand labels are dealt "
           "into folds; one is held out, and from the others the machine learns more and more "
           "labels, in the order in which the queue asks for them and in random orders. Both are "
           "judged on the same held-out labels. What was asked for is harder than the rest, so "
           "the bout as a whole fares better."));
    connect(aspects_, &QComboBox::currentIndexChanged, this, [this] {
        open_.reset();
        showMatrix();
    });
    connect(matrix_, &ConfusionMatrix::opened, this, [this](const ConfusionCell& cell) {
        // Once more closes it.
        if (open_ == cell) return closeCell();
        openCell(cell);
    });
    const auto point = [this](const QString& text) {
        const auto& current = matrix_->current();
        said_->setText(text.isEmpty() && current ? matrix_->cellText(*current) : text);
    };
    connect(matrix_, &ConfusionMatrix::pointed, this, point);
    connect(plot_, &LearningPlot::pointed, &labels_.session(), &Session::hovered);
    connect(&labels_, &LabelSession::changed, this, &QualityBox::follow);
    for (JobRunner* jobs : {&judging_, &ordering_})
        connect(jobs, &JobRunner::failed, &labels_.session(), &Session::hinted);
    showMatrix();
    showPlot();
}

int QualityBox::aspect() const {
    return aspects_->currentIndex();
}

void QualityBox::setAspect(int aspect) {
    aspects_->setCurrentIndex(aspect);
}

void QualityBox::showEvent(QShowEvent*) {
    follow();
}

void QualityBox::follow() {
    if (!isVisible()) return;
    fillAspects();
    showPlot();
    // Only what is calibrated is settled: margins come and go with every key.
    if (!labels_.isCurrent(true) || !labels_.session().document().isCurrent()) return;
    if (judged_ != labels_.learnt()) judge();
    const auto examples = [](const auto& learnt) { return learnt ? learnt->examples.size() : 0; };
    const bool other = !ordered_ || ordered_->ground != labels_.learnt()->ground ||
                       examples(ordered_) > examples(labels_.learnt());
    const auto batch = static_cast<std::size_t>(labels_.querySettings().batch);
    if (other || examples(labels_.learnt()) >= examples(ordered_) + batch) order();
}

void QualityBox::fillAspects() {
    const Vocabulary& vocabulary = labels_.vocabulary();
    QStringList names;
    for (const Aspect& aspect : vocabulary.aspects)
        names.append(vocabularyWords(aspect.name));
    QStringList shown;
    for (int i = 0; i < aspects_->count(); ++i)
        shown.append(aspects_->itemText(i));
    if (names == shown) return;
    const QSignalBlocker quiet(aspects_);
    aspects_->clear();
    aspects_->addItems(names);
    judgement_ = {};
    open_.reset();
    showMatrix();
}

void QualityBox::judge() {
    judged_ = labels_.learnt();
    const Document& document = labels_.session().document();
    judging_.start(
        tr("Judging"),
        [project = document.project(), analysis = document.analysis(),
         learnt = judged_](const Progress& progress) {
            return judgeHandLabels(project, analysis, learnt->ground->table, learnt->parameters,
                                   learnt->proposals, progress);
        },
        [this](HandJudgement judgement) {
            judgement_ = std::move(judgement);
            showMatrix();
            Q_EMIT updated();
        });
}

void QualityBox::order() {
    ordered_ = labels_.learnt();
    ordering_.start(
        tr("Comparing orders"),
        [learnt = ordered_, settings = labels_.session().document().project().labelling.learning](
            const Progress& progress) {
            return orderCurves(*learnt->vocabulary, learnt->ground->table.features,
                               learnt->examples, settings, learnt->parameters, progress);
        },
        [this](OrderCurves curves) {
            orders_ = std::move(curves);
            showPlot();
            Q_EMIT updated();
        });
}

void QualityBox::showMatrix() {
    const int chosen = aspect();
    const bool judged = chosen >= 0 && !judgement_.actions.empty() &&
                        static_cast<int>(judgement_.scores.aspects.size()) > chosen;
    const Vocabulary& vocabulary = labels_.vocabulary();
    matrix_->setVisible(judged);
    said_->setVisible(judged);
    if (!judged) {
        accuracy_->setText(
            tr("How often machine and rules say the same as your hand appears here, once some "
               "actions are labelled by hand."));
        return closeCell();
    }
    const AspectScore& score = judgement_.scores.aspects[static_cast<std::size_t>(chosen)];
    const ConfusionTable table = tableOf(vocabulary[chosen], score);
    matrix_->show(table);
    int by = 0;
    for (int hand = 0; hand < table.size(); ++hand)
        by += table.row(hand);
    accuracy_->setText(by == 0 ? tr("No hand has said anything of this aspect.")
                               : tr("Rows by hand, columns %1. %2 of %3 right, F1 %4.")
                                     .arg(table.byRule ? tr("by rule") : tr("by machine, unseen"),
                                          percentText(score.accuracy))
                                     .arg(by)
                                     .arg(numberText(score.macroF1, 2)));
    const auto& current = matrix_->current();
    said_->setText(current ? matrix_->cellText(*current)
                           : tr("A click on a cell, or Enter, opens its actions."));
    if (open_) {
        openCell(*open_);
    } else {
        closeCell();
    }
}

void QualityBox::closeCell() {
    open_.reset();
    list_->setVisible(false);
    showPlot();
}

void QualityBox::openCell(const ConfusionCell& cell) {
    const int chosen = aspect();
    const Aspect& of = labels_.vocabulary()[chosen];
    const bool unanswered = cell.answer >= static_cast<int>(of.qualifiers.size());
    const bool other = open_ != cell;
    open_ = cell;
    std::vector<FoundRow> rows;
    for (const std::size_t i :
         judgement_.cell(chosen, cell.hand, unanswered ? kUnknown : cell.answer)) {
        const JudgedAction& judged = judgement_.actions[i];
        const auto& segmentation =
            labels_.session().document().analysis().at(judged.fighter).segmentation;
        if (!segmentation || judged.action >= static_cast<int>(segmentation->actions.size()))
            continue;
        const int peak = segmentation->actions[static_cast<std::size_t>(judged.action)].peak;
        FoundRow row{judged.fighter,
                     peak,
                     labelWords(labels_.vocabulary(), judged.hand),
                     sourceWords(LabelSource::Hand),
                     {}};
        rows.push_back(std::move(row));
    }
    said_->setText(matrix_->cellText(cell));
    list_->setVisible(true);
    showPlot();
    const bool any = !rows.empty();
    list_->show(std::move(rows), tr("No action is in this cell."));
    if (any && other) list_->step(1);
}

void QualityBox::showPlot() {
    LearningPlotValues values;
    for (const LearnedPoint& point : labels_.curve())
        values.expected.emplace_back(point.labelled, point.expectedAccuracy);
    values.orders = orders_;
    values.mayStop = labels_.progress().mayStop;
    plot_->show(values);
    // Matrix and list need the room while a cell is open.
    plot_->setVisible(!plot_->isEmpty() && !open_);
    QString text;
    // What was asked for is hard: judged on that alone, asking rarely shows what it is worth.
    constexpr double kWorthSaying = 1.2;
    const auto gain = orderGain(orders_);
    if (gain && gain->random >= kWorthSaying * gain->asked) {
        text = tr("%1 labels as asked do what %2 in random order do.")
                   .arg(gain->asked)
                   .arg(gain->random);
    } else if (orders_.points.empty() && !values.expected.empty()) {
        text = tr("With %1 hand labels the order of the questions is compared with a random one.")
                   .arg(kFewestForCurves);
    }
    if (values.mayStop) text += QLatin1Char(' ') + tr("More labels will hardly help.");
    gain_->setText(text.trimmed());
    gain_->setVisible(!gain_->text().isEmpty() && !open_);
}

}  // namespace kumite::studio
