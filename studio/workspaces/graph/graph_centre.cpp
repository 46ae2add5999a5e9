#include "studio/workspaces/graph/graph_centre.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <utility>

#include "studio/app/flow_row.h"
#include "studio/app/words.h"
#include "studio/workspaces/graph/matrix_page.h"
#include "studio/workspaces/graph/node_page.h"

namespace kumite::studio {

namespace {

/// What the box of comparisons offers, in its order.
struct Comparison {
    Versus versus;
    LabelEstimator estimator = LabelEstimator::Equ5;
};
constexpr std::array<Comparison, 6> kComparisons = {{{Versus::Nothing},
                                                     {Versus::OtherFighter},
                                                     {Versus::HandLabels},
                                                     {Versus::Estimator, LabelEstimator::Equ7},
                                                     {Versus::Estimator, LabelEstimator::Equ6},
                                                     {Versus::Estimator, LabelEstimator::Equ5}}};

}  // namespace

GraphCentre::GraphCentre(GraphSession& graph, QWidget* parent)
    : QWidget(parent),
      graph_(graph),
      pages_(new QStackedWidget(this)),
      views_(new QStackedWidget(pages_)),
      matrix_(new MatrixPage(graph, views_)),
      nodes_(new NodePage(graph, views_)),
      viewButtons_(new QButtonGroup(this)),
      moverButtons_(new QButtonGroup(this)),
      versus_(new QComboBox(this)),
      why_(new QLabel(this)) {
    setMinimumWidth(320);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(pages_);
    views_->addWidget(matrix_);
    views_->addWidget(nodes_);
    auto* content = new QWidget(pages_);
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(0, 6, 0, 0);
    rows->setSpacing(4);
    rows->addWidget(makeHeader());
    rows->addWidget(views_, 1);
    pages_->addWidget(makeEmptyPage());
    pages_->addWidget(content);
    connect(&graph_, &GraphSession::valuesChanged, this, &GraphCentre::refresh);
    connect(&graph_, &GraphSession::optionsChanged, this, &GraphCentre::refresh);
    refresh();
}

QWidget* GraphCentre::makeHeader() {
    auto* header = new QWidget(this);
    auto* row = new FlowRow(header);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(4);
    const auto addButton = [&](QButtonGroup* group, int id, const QString& text,
                               const QString& tip) {
        auto* button = new QToolButton(header);
        button->setText(text);
        button->setToolTip(tip);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        group->addButton(button, id);
        row->addWidget(button);
    };
    addButton(viewButtons_, 0, tr("Matrix"), tr("Transitions as a matrix (V)"));
    addButton(viewButtons_, 1, tr("Graph"), tr("Transitions as circles and edges (V)"));
    viewButtons_->button(0)->setChecked(true);
    connect(viewButtons_, &QButtonGroup::idClicked, this, [this](int id) { showMatrix(id == 0); });
    row->addSpacing(8);
    for (const int player : {0, 1}) {
        QString name = fighterText(player);
        name[0] = name[0].toUpper();
        addButton(moverButtons_, player, name,
                  tr("What %1 does next (Tab)").arg(fighterText(player)));
    }
    connect(moverButtons_, &QButtonGroup::idClicked, this,
            [this](int id) { graph_.session().setActivePlayer(id); });
    row->addSpacing(8);
    versus_->addItems({tr("compared with nothing"), tr("with the other fighter"),
                       tr("with labels by hand alone"), tr("with EQU7"), tr("with EQU6"),
                       tr("with EQU5")});
    versus_->setAccessibleName(tr("What it is compared with"));
    versus_->setToolTip(tr("Compares with another, side by side or as a difference"));
    versus_->setFocusPolicy(Qt::TabFocus);
    connect(versus_, &QComboBox::currentIndexChanged, this, [this](int index) {
        const auto& chosen = kComparisons[static_cast<std::size_t>(index)];
        GraphOptions options = graph_.options();
        options.versus = chosen.versus;
        options.versusEstimator = chosen.estimator;
        graph_.setOptions(options);
    });
    row->addWidget(versus_);
    return header;
}

QWidget* GraphCentre::makeEmptyPage() {
    auto* page = new QWidget(this);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(32, 32, 32, 32);
    layout->addStretch(1);
    auto* title = new QLabel(tr("What each fighter tends to do next"), page);
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() + 4);
    title->setFont(large);
    title->setAlignment(Qt::AlignCenter);
    title->setWordWrap(true);
    layout->addWidget(title);
    layout->addSpacing(8);
    why_->setWordWrap(true);
    why_->setAlignment(Qt::AlignCenter);
    why_->setProperty("role", "second");
    why_->setAccessibleName(tr("Why nothing is shown"));
    layout->addWidget(why_);
    layout->addSpacing(12);
    steps_ = new QHBoxLayout;
    steps_->setSpacing(8);
    steps_->addStretch(1);
    steps_->addStretch(1);
    layout->addLayout(steps_);
    layout->addStretch(2);
    return page;
}

void GraphCentre::addStep(const QString& text, const QString& tip, std::function<void()> run) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    if (steps_->count() == 2) button->setProperty("role", "step");
    connect(button, &QPushButton::clicked, this, std::move(run));
    steps_->insertWidget(steps_->count() - 1, button);
}

bool GraphCentre::showsMatrix() const {
    return views_->currentWidget() == matrix_;
}

void GraphCentre::showMatrix(bool matrix) {
    views_->setCurrentWidget(matrix ? static_cast<QWidget*>(matrix_) : nodes_);
    viewButtons_->button(matrix ? 0 : 1)->setChecked(true);
    refresh();
}

void GraphCentre::refresh() {
    pages_->setCurrentIndex(graph_.hasGraph() ? 1 : 0);
    why_->setText(graph_.values() == nullptr ? tr("Transitions are being learnt from the labels.")
                                             : graph_.values()->whyNothing);
    const bool both = graph_.options().versus == Versus::OtherFighter;
    moverButtons_->button(graph_.mover())->setChecked(true);
    for (QAbstractButton* button : moverButtons_->buttons())
        button->setEnabled(!both || !showsMatrix());
}

}  // namespace kumite::studio
