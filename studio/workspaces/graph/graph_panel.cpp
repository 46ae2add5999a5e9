#include "studio/workspaces/graph/graph_panel.h"

#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/graph/trace_box.h"
#include "studio/workspaces/graph/what_if_box.h"

namespace kumite::studio {

GraphPanel::GraphPanel(GraphSession& graph, QWidget* parent)
    : QWidget(parent),
      graph_(graph),
      empty_(new QLabel(this)),
      boxes_(new QSplitter(Qt::Vertical, this)),
      whatIf_(new WhatIfBox(graph, boxes_)),
      trace_(new TraceBox(graph, boxes_)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    empty_->setText(
        tr("What a fighter does next, given what both are doing, and the moments of the recording "
           "behind each probability appear here."));
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop);
    empty_->setProperty("role", "second");
    layout->addWidget(empty_, 1);
    boxes_->setChildrenCollapsible(false);
    boxes_->setHandleWidth(9);
    boxes_->setStyleSheet(QStringLiteral("QSplitter::handle { background: transparent; }"));
    boxes_->setStretchFactor(0, 3);
    boxes_->setStretchFactor(1, 2);
    boxes_->setSizes({300, 200});
    layout->addWidget(boxes_, 1);
    setMinimumWidth(200);
    connect(&graph_, &GraphSession::valuesChanged, this, &GraphPanel::refresh);
    refresh();
}

void GraphPanel::refresh() {
    boxes_->setVisible(graph_.hasGraph());
    empty_->setVisible(!graph_.hasGraph());
}

}  // namespace kumite::studio
