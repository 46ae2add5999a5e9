#include "studio/workspaces/graph/node_page.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

#include "studio/app/theme.h"
#include "studio/app/words.h"
#include "studio/view3d/graph_view.h"

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
    least_->setRange(0, kLeastSteps);
    least_->setAccessibleName(tr("Least probability of an edge"));
    most_->setRange(1, kMostEdges);
    most_->setValue(options_.most);
    most_->setAccessibleName(tr("Most edges from a node"));
    layOut();
    connect(space_, &QToolButton::toggled, this, &NodePage::setInSpace);
    connect(cross_, &QCheckBox::toggled, this, [this](bool on) {
        options_.crossEdges = on;
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
    connect(&graph_, &GraphSession::selectionChanged, this, &NodePage::refresh);
    connect(&graph_, &GraphSession::momentChanged, this, [this] {
        if (isVisible()) refresh();
    });
    refresh();
}

void NodePage::layOut() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(6);
    row->addWidget(space_);
    row->addWidget(cross_);
    const auto addSlider = [&](QLabel* text, QSlider* slider, const QString& widest) {
        text->setProperty("role", "second");
        text->setMinimumWidth(fontMetrics().horizontalAdvance(widest));
        slider->setMaximumWidth(110);
        slider->setMinimumWidth(50);
        slider->setFocusPolicy(Qt::TabFocus);
        row->addSpacing(4);
        row->addWidget(text);
        row->addWidget(slider, 1);
    };
    addSlider(leastText_, least_, tr("P ≥ 0.000"));
    addSlider(mostText_, most_, tr("12 a node"));
    row->addStretch(1);
    layout->addLayout(row);
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
    leastText_->setText(tr("P ≥ %1").arg(QString::number(options_.least, 'f', 3)));
    mostText_->setText(tr("%1 a node").arg(options_.most));
}

void NodePage::refresh() {
    showNumbers();
    if (!graph_.hasGraph()) return;
    options_.upright = view_->height() > view_->width();
    drawing_ = drawGraph(graph_, options_, coloursFor(palette()));
    view_->show(drawing_.scene);
}

std::optional<GraphSelection> NodePage::meaningOf(const GraphPick& pick) const {
    const auto index = static_cast<std::size_t>(pick.index);
    if (pick.kind == GraphPick::Kind::Edge) {
        return index < drawing_.edges.size() ? std::optional(drawing_.edges[index]) : std::nullopt;
    }
    if (index >= drawing_.nodes.size()) return std::nullopt;
    const GraphDrawing::NodeRef& node = drawing_.nodes[index];
    return GraphSelection{node.player, {node.node, kAnyNode, kAnyNode}};
}

void NodePage::choose(const std::optional<GraphPick>& pick) {
    graph_.select(pick ? meaningOf(*pick) : std::nullopt);
}

void NodePage::tell(const std::optional<GraphPick>& pick) {
    const auto meaning = pick ? meaningOf(*pick) : std::nullopt;
    QString text;
    if (meaning && pick->kind == GraphPick::Kind::Node) {
        const auto& node = graph_.graph().node(meaning->mover, meaning->filter.own);
        text = tr("%1: %2   ·   %3 actions")
                   .arg(fighterText(meaning->mover),
                        graph_.nameOf(meaning->mover, meaning->filter.own))
                   .arg(node.actions.size());
    } else if (meaning) {
        const bool cross = meaning->filter.own == kAnyNode;
        const int mover = meaning->mover;
        const int from = cross ? meaning->filter.opponent : meaning->filter.own;
        text = tr("%1: %2 → %3   ·   P %4   ·   seen %5 times")
                   .arg(cross ? tr("%1 on %2").arg(fighterText(mover), fighterText(1 - mover))
                              : fighterText(mover),
                        graph_.nameOf(cross ? 1 - mover : mover, from),
                        graph_.nameOf(mover, meaning->filter.next),
                        QString::number(
                            drawing_.probabilities[static_cast<std::size_t>(pick->index)], 'f', 3))
                   .arg(transitionsBehind(graph_.graph(), mover, meaning->filter).size());
    }
    Q_EMIT graph_.session().hovered(text);
}

void NodePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
}

void NodePage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool upright = view_->height() > view_->width();
    if (upright != options_.upright) refresh();
}

}  // namespace kumite::studio
