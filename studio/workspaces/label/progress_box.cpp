#include "studio/workspaces/label/progress_box.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

#include "core/project/review.h"
#include "studio/app/core_words.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/workspaces/label/label_session.h"

namespace kumite::studio {

namespace {

/// What counts as sure at first.
constexpr double kSure = 0.9;
/// Below it a finished labelling is not called one.
constexpr double kGoodAccuracy = 0.9;
/// What the machine is less sure of is called a guess.
constexpr double kGuess = 0.7;
/// So many suspect minima are worth correcting before labelling.
constexpr int kMany = 3;

/// Suspects of the shown take that nobody has judged.
int suspectsLeft(const Session& session) {
    const double threshold = session.document().analysis().settings.prominence;
    int left = 0;
    for (int player = 0; player < session.playerCount(); ++player) {
        if (const FighterAnalysis* fighter = session.fighter(player))
            left += reviewStatistics(*fighter, threshold).toReview;
    }
    return left;
}

/// By hand solid, accepted lighter, open empty.
class ProgressStrip : public QWidget {
public:
    ProgressStrip(const LabelSession& labels, QWidget* parent) : QWidget(parent), labels_(labels) {
        setFixedHeight(8);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const Colours& c = coloursFor(palette());
        const LabelProgress& progress = labels_.progress();
        painter.fillRect(rect(), mixed(c.panel, c.line, 0.6));
        if (progress.actions == 0) return;
        const double unit = static_cast<double>(width()) / progress.actions;
        const double hand = progress.byHand * unit;
        painter.fillRect(QRectF(0, 0, hand, height()), c.accent);
        painter.fillRect(QRectF(hand, 0, progress.accepted * unit, height()),
                         mixed(c.panel, c.accent, 0.45));
    }

private:
    const LabelSession& labels_;
};

}  // namespace

ProgressBox::ProgressBox(LabelSession& labels, KeyOf keyOf, QWidget* parent)
    : QWidget(parent),
      labels_(labels),
      keyOf_(std::move(keyOf)),
      bar_(new ProgressStrip(labels, this)),
      counts_(new QLabel(this)),
      advice_(new QLabel(this)),
      threshold_(new QDoubleSpinBox(this)),
      accept_(new QPushButton(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(bar_);
    layout->addWidget(counts_);
    layout->addWidget(advice_);
    counts_->setWordWrap(true);
    counts_->setAccessibleName(tr("Progress of labelling"));
    advice_->setWordWrap(true);
    advice_->setProperty("role", "second");
    advice_->setAccessibleName(tr("What to do next"));
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(accept_, 1);
    row->addWidget(threshold_);
    layout->addLayout(row);
    accept_->setFocusPolicy(Qt::TabFocus);
    accept_->setToolTip(
        tr("Keep what machine and rules propose where they are at least so sure; "
           "one step of the history (Ctrl+Return)"));
    bar_->setAccessibleName(tr("Labelled by hand, accepted, open"));
    threshold_->setRange(0, 1);
    threshold_->setSingleStep(0.05);
    threshold_->setDecimals(2);
    threshold_->setPrefix(QStringLiteral("p ≥ "));
    threshold_->setValue(kSure);
    threshold_->setToolTip(
        tr("How sure the machine must be of what is accepted: 0.90 is nine of ten right. "
           "Ctrl+Down and Ctrl+Up move it."));
    threshold_->setAccessibleName(tr("Least probability of what is accepted"));
    threshold_->setToolTip(tr("Proposals that are at least so probable are accepted."));
    connect(threshold_, &QDoubleSpinBox::valueChanged, this, &ProgressBox::refresh);
    // A bar that was lowered for one project is none for the next.
    connect(&labels_.session().document(), &Document::opened, threshold_,
            [this] { threshold_->setValue(kSure); });
    connect(accept_, &QPushButton::clicked, this, &ProgressBox::acceptWanted);
}

double ProgressBox::threshold() const {
    return threshold_->value();
}

void ProgressBox::moveThreshold(double by) {
    threshold_->setValue(threshold_->value() + by);
}

void ProgressBox::refresh() {
    const LabelProgress& progress = labels_.progress();
    bar_->update();
    bar_->setToolTip(tr("%1 actions: %2 labelled by hand (dark), %3 accepted (light), %4 open")
                         .arg(progress.actions)
                         .arg(progress.byHand)
                         .arg(progress.accepted)
                         .arg(progress.actions - progress.byHand - progress.accepted));
    // A few labels say nothing about the rest.
    constexpr int kTells = 10;
    QString counts = tr("%1 labelled").arg(percentText(progress.labelledShare()));
    if (progress.expectedAccuracy && progress.byHand >= kTells) {
        counts += tr(", expected accuracy %1").arg(percentText(*progress.expectedAccuracy));
    }
    counts.replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"));
    counts_->setText(counts);
    counts_->setToolTip(
        tr("How many of the machine's answers should be right where no hand has spoken"));
    advice_->setText(adviceText());
    const int sure = labels_.countSure(threshold());
    const bool anyLeft = progress.actions > 0 && progress.settled < progress.actions;
    const bool onlyRules = anyLeft && sure == 0 && labels_.queue().empty();
    // How many there are is known once the machine has learnt the last answer.
    accept_->setText(onlyRules                  ? tr("Accept rules")
                     : !labels_.isCurrent(true) ? tr("Accept the sure")
                     : threshold() < kGuess     ? tr("Accept %1 guesses").arg(sure)
                                                : tr("Accept %1 sure").arg(sure));
    accept_->setEnabled(anyLeft && progress.byHand > 0 && (sure > 0 || onlyRules));
}

QStringList ProgressBox::seenOnce() const {
    QStringList names;
    const Vocabulary& vocabulary = labels_.vocabulary();
    if (!labels_.learnt() || labels_.actions().empty()) return names;
    const ShownAction& any = labels_.actions().front();
    for (int a = 0; a < vocabulary.size(); ++a) {
        const Prediction& said = any.aspects[static_cast<std::size_t>(a)].prediction;
        if (vocabulary[a].classifier == Classifier::Msvm && said.blind &&
            said.qualifier != kUnknown)
            names.append(vocabularyInText(vocabulary[a].name));
    }
    return names;
}

QString ProgressBox::finishedText() const {
    const LabelProgress& progress = labels_.progress();
    const double expected = progress.expectedAccuracy.value_or(1);
    if (progress.accepted > progress.byHand && expected < kGoodAccuracy) {
        return tr("Every action has a label, but of ten that the machine gave only about %1 are "
                  "right. N leads through those of which it was least sure; or undo the "
                  "acceptance and answer more questions.")
            .arg(std::lround(10 * expected));
    }
    return tr(
        "Every action is labelled. File > Save keeps it; Label > Write labels… makes a table.");
}

QString ProgressBox::adviceText() const {
    const LabelProgress& progress = labels_.progress();
    if (progress.actions == 0) return tr("No recording is cut into actions yet.");
    if (progress.settled == progress.actions) {
        return finishedText();
    }
    const int few = labels_.querySettings().batch;
    if (progress.byHand == 0) {
        if (const int suspects = suspectsLeft(labels_.session()); suspects >= kMany) {
            return tr(
                "%n minima are still suspect. Half actions are hard to label: correct them "
                "in Segment first, or go on with N.",
                nullptr, suspects);
        }
        return tr(
            "Label a few actions by hand; the machine proposes the others. N leads to the "
            "one that says most.");
    }
    if (progress.byHand < few) return tr("Go on: N leads to the next one that says most.");
    if (labels_.queue().empty()) return tr("What rules say is left to be accepted.");
    if (progress.mayStop) {
        return tr("More labels by hand will hardly help: accept the sure rest (%1), lower the "
                  "bar for the others (%2), then look through the least sure (%3).")
            .arg(keyOf_("label.acceptSure"), keyOf_("label.barDown"), keyOf_("label.next"));
    }
    const QStringList unseen = seenOnce();
    if (!unseen.isEmpty()) {
        return tr("Nothing of %1 was labelled so far: if there is any, show the machine one.")
            .arg(unseen.join(tr(", ")));
    }
    return tr("Go on: the next ones tell the machine most.");
}

}  // namespace kumite::studio
