#include "studio/workspaces/graph/node_page.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

#include "studio/app/comfort.h"
#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/view3d/graph_view.h"
#include "studio/workspaces/graph/chooser_row.h"

namespace kumite::studio {

namespace {

constexpr int kLeastSteps = 100;
constexpr int kMostEdges = 12;

/// Finer where probabilities are small: 0 … 0.5.
double leastOf(int step) {
    const double share = static_cast<double>(step) / kLeastSteps;
    return 0.5 * share * share;
}

}  // namespace

NodePage::NodePage(GraphSession& graph, QWidget* parent)
    : QWidget(parent),
      graph_(graph),
      view_(new GraphView(this)),
      space_(new QToolButton(this)),
      cross_(new QCheckBox(tr("cross edges"), this)),
      difference_(new QCheckBox(tr("difference"), this)),
      least_(new QSlider(Qt::Horizontal, this)),
      most_(new QSlider(Qt::Horizontal, this)),
      leastText_(new QLabel(this)),
      mostText_(new QLabel(this)) {
    space_->setText(tr("3D"));
    space_->setCheckable(true);
    space_->setFocusPolicy(Qt::TabFocus);
    space_->setToolTip(tr("Fighter 1's graph before fighter 2's, cross edges between; drag turns"));
    cross_->setToolTip(
        tr("Also what a fighter does next given what the opponent is doing; those of what is "
           "selected show always"));
    difference_->setToolTip(
        tr("Of each side only what it does more often than the other, as wide as the difference"));
    least_->setRange(0, kLeastSteps);
    least_->setAccessibleName(tr("Least probability of an edge"));
    least_->setToolTip(tr("Edges that are less probable are not drawn."));
    most_->setRange(1, kMostEdges);
    most_->setValue(options_.most);
    most_->setAccessibleName(tr("Most edges from a node"));
    most_->setToolTip(tr("So many edges of each node are drawn, the likeliest ones."));
    layOut();
    connect(space_, &QToolButton::toggled, this, &NodePage::setInSpace);
    connect(cross_, &QCheckBox::toggled, this, [this](bool on) {
        options_.crossEdges = on;
        refresh();
    });
    connect(difference_, &QCheckBox::toggled, this, [this](bool on) {
        options_.difference = on;
        refresh();
    });
    connect(least_, &QSlider::valueChanged, this, [this](int step) {
        options_.least = leastOf(step);
        refresh();
    });
    connect(most_, &QSlider::valueChanged, this, [this](int count) {
        options_.most = count;
        refresh();
    });
    connect(view_, &GraphView::clicked, this, &NodePage::choose);
    connect(view_, &GraphView::hovered, this, &NodePage::tell);
    connect(view_, &GraphView::activated, this, [this](const GraphPick& pick) {
        choose(pick);
        graph_.playNext();
    });
    connect(&graph_, &GraphSession::valuesChanged, this, &NodePage::refresh);
    connect(&graph_, &GraphSession::optionsChanged, this, &NodePage::refresh);
    connect(&graph_, &GraphSession::selectionChanged, this, &NodePage::refresh);
    connect(&graph_, &GraphSession::momentChanged, this, &NodePage::refresh);
    refresh();
}

void NodePage::layOut() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    FlowRow* row = addChooserRow(*layout);
    row->addWidget(space_);
    row->addWidget(cross_);
    row->addWidget(difference_);
    const auto addSlider = [&](QLabel* text, QSlider* slider, const QString& widest) {
        text->setProperty("role", "second");
        text->setMinimumWidth(fontMetrics().horizontalAdvance(widest));
        slider->setFixedWidth(withTextSize(64));
        slider->setFocusPolicy(Qt::TabFocus);
        auto* pair = new QWidget(this);
        auto* both = new QHBoxLayout(pair);
        both->setContentsMargins(4, 0, 0, 0);
        both->setSpacing(4);
        both->addWidget(text);
        both->addWidget(slider);
        row->addWidget(pair);
    };
    addSlider(leastText_, least_, tr("ΔP ≥ 0.000"));
    addSlider(mostText_, most_, tr("12 a node"));
    layout->addWidget(view_, 1);
}

void NodePage::setInSpace(bool inSpace) {
    space_->setChecked(inSpace);
    if (options_.inSpace == inSpace) return;
    options_.inSpace = inSpace;
    refresh();
    view_->setFlat(!inSpace);
}

void NodePage::showNumbers() {
    const QString sign = graph_.compares() && options_.difference ? tr("ΔP ≥ %1") : tr("P ≥ %1");
    leastText_->setText(sign.arg(numberText(options_.least, 3)));
    mostText_->setText(tr("%1 a node").arg(options_.most));
}

void NodePage::refresh() {
    showNumbers();
    // What is hidden is drawn when it is shown.
    if (!graph_.hasGraph() || !isVisible()) return;
    const bool models = graph_.compares() && graph_.options().versus != Versus::OtherFighter;
    difference_->setVisible(graph_.compares());
    cross_->setVisible(!models);  // the opponent's labels stand in neither side
    options_.aspect = aspect();
    drawing_ = drawGraph(graph_, options_, coloursFor(palette()));
    view_->show(drawing_.scene);
}

double NodePage::aspect() const {
    return static_cast<double>(view_->width()) / std::max(1, view_->height());
}

std::optional<GraphSelection> NodePage::meaningOf(const GraphPick& pick) const {
    const auto index = static_cast<std::size_t>(pick.index);
    GraphSelection meaning;
    std::size_t side = 0;
    if (pick.kind == GraphPick::Kind::Edge) {
        if (index >= drawing_.edges.size()) return std::nullopt;
        meaning = drawing_.edges[index].meaning;
        side = static_cast<std::size_t>(drawing_.edges[index].side);
    } else {
        if (index >= drawing_.nodes.size()) return std::nullopt;
        const GraphDrawing::NodeRef& node = drawing_.nodes[index];
        meaning = {node.player, {node.node, kAnyNode, kAnyNode}};
        side = static_cast<std::size_t>(node.side);
    }
    return carried(meaning, drawing_.sides[side].graph(), graph_.graph());
}

void NodePage::choose(const std::optional<GraphPick>& pick) {
    graph_.select(pick ? meaningOf(*pick) : std::nullopt);
}

void NodePage::tell(const std::optional<GraphPick>& pick) {
    const auto index = pick ? static_cast<std::size_t>(pick->index) : 0;
    const auto nameOf = [this](int side, int player, int node) {
        const CoupledGraph& graph = drawing_.sides[static_cast<std::size_t>(side)].graph();
        return shortLabelWords(*graph.vocabulary, graph.node(player, node).label);
    };
    QString text;
    if (pick && pick->kind == GraphPick::Kind::Node && index < drawing_.nodes.size()) {
        const auto& [side, player, node] = drawing_.nodes[index];
        const GraphSide& where = drawing_.sides[static_cast<std::size_t>(side)];
        text = tr("%1: %2   ·   %3 actions")
                   .arg(where.name, nameOf(side, player, node))
                   .arg(where.graph().node(player, node).actions.size());
    } else if (pick && pick->kind == GraphPick::Kind::Edge && index < drawing_.edges.size()) {
        const auto& [side, meaning, probability] = drawing_.edges[index];
        const GraphSide& where = drawing_.sides[static_cast<std::size_t>(side)];
        const bool cross = meaning.filter.own == kAnyNode;
        const int mover = meaning.mover;
        const int from = cross ? meaning.filter.opponent : meaning.filter.own;
        text = tr("%1: %2 → %3   ·   %4 %5   ·   seen %6 times")
                   .arg(cross ? tr("%1 on %2").arg(fighterText(mover), fighterText(1 - mover))
                              : where.name,
                        nameOf(side, cross ? 1 - mover : mover, from),
                        nameOf(side, mover, meaning.filter.next),
                        options_.difference && graph_.compares() ? tr("more often by") : tr("P"),
                        numberText(probability, 3))
                   .arg(transitionsBehind(where.graph(), mover, meaning.filter).size());
    }
    Q_EMIT graph_.session().hovered(text);
}

void NodePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
}

void NodePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void NodePage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (!options_.inSpace && aspect() != options_.aspect) refresh();
}

}  // namespace kumite::studio
