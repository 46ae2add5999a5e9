#pragma once

#include <QWidget>

#include "core/project/interaction.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListView;

namespace kumite::studio {

class GraphSession;
class WhatIfModel;

/// What does a fighter do next? Both current labels are picked, or are those at the playhead.
class WhatIfBox : public QWidget {
    Q_OBJECT

public:
    explicit WhatIfBox(GraphSession& graph, QWidget* parent = nullptr);

    const WhatIfModel& model() const { return *model_; }
    QListView* list() const { return list_; }
    /// The labels are those at the playhead.
    bool isFollowing() const;
    void setFollowing(bool following);

private:
    void layOut();
    void fillLabels();
    void followPlayhead();
    void followSelection();
    void rank();
    void show(const Moment& decision, int actual);
    void chooseRow(int row);

    GraphSession& graph_;
    WhatIfModel* model_;
    QCheckBox* follow_;
    QComboBox* own_;
    QComboBox* opponent_;
    QLabel* title_;
    QListView* list_;
    bool filling_ = false;
};

}  // namespace kumite::studio
