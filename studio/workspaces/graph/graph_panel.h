#pragma once

#include <QWidget>

class QLabel;
class QSplitter;

namespace kumite::studio {

class GraphSession;
class TraceBox;
class WhatIfBox;

/// The Graph workspace's panel: what comes next, and what is behind what is selected.
class GraphPanel : public QWidget {
    Q_OBJECT

public:
    explicit GraphPanel(GraphSession& graph, QWidget* parent = nullptr);

    WhatIfBox& whatIf() { return *whatIf_; }
    TraceBox& trace() { return *trace_; }

private:
    void refresh();

    GraphSession& graph_;
    QLabel* empty_;
    QSplitter* boxes_;
    WhatIfBox* whatIf_;
    TraceBox* trace_;
};

}  // namespace kumite::studio
