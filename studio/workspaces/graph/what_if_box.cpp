#include "studio/workspaces/graph/what_if_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QListView>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/words.h"
#include "studio/workspaces/graph/graph_session.h"
#include "studio/workspaces/graph/what_if_model.h"

namespace kumite::studio {

namespace {

/// Labels are longer than the box, and both their ends tell them apart.
class LabelChoice : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void paintEvent(QPaintEvent*) override {
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const QRect field = style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                    QStyle::SC_ComboBoxEditField, this);
        option.currentText =
            fontMetrics().elidedText(option.currentText, Qt::ElideMiddle, field.width() - 4);
        QStylePainter painter(this);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }
};

}  // namespace

WhatIfBox::WhatIfBox(GraphSession& graph, QWidget* parent)
    : QWidget(parent),
      graph_(graph),
      model_(new WhatIfModel(graph, this)),
      follow_(new QCheckBox(tr("at playhead"), this)),
      own_(new LabelChoice(this)),
      opponent_(new LabelChoice(this)),
      title_(new QLabel(this)),
      list_(new QListView(this)) {
    layOut();
    follow_->setChecked(true);
    connect(follow_, &QCheckBox::toggled, this, &WhatIfBox::followPlayhead);
    for (QComboBox* box : {own_, opponent_}) {
        connect(box, &QComboBox::activated, this, [this] { setFollowing(false); });
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            if (!filling_) rank();
        });
        connect(box, &QComboBox::currentTextChanged, box, &QWidget::setToolTip);
    }
    connect(&graph_, &GraphSession::valuesChanged, this, &WhatIfBox::fillLabels);
    connect(&graph_, &GraphSession::optionsChanged, this, &WhatIfBox::fillLabels);
    connect(&graph_, &GraphSession::momentChanged, this, &WhatIfBox::followPlayhead);
    connect(&graph_, &GraphSession::selectionChanged, this, &WhatIfBox::followSelection);
    connect(&graph_, &GraphSession::currentChanged, this, [this] {
        if (!isFollowing()) rank();
        followSelection();
    });
    fillLabels();
}

void WhatIfBox::layOut() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* head = new QHBoxLayout;
    title_->setProperty("role", "heading");
    head->addWidget(title_, 1);
    follow_->setToolTip(tr("Both labels are those of the moment that is shown"));
    head->addWidget(follow_);
    layout->addLayout(head);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    const auto add = [&](int row, const QString& text, QComboBox* box, const QString& name) {
        auto* label = new QLabel(text, this);
        label->setProperty("role", "second");
        grid->addWidget(label, row, 0);
        grid->addWidget(box, row, 1);
        box->setAccessibleName(name);
        box->setFocusPolicy(Qt::TabFocus);
        box->setMinimumContentsLength(6);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    };
    add(0, tr("own"), own_, tr("What the fighter does now"));
    add(1, tr("opponent"), opponent_, tr("What the opponent does now"));
    grid->setColumnStretch(1, 1);
    layout->addLayout(grid);
    list_->setModel(model_);
    list_->setItemDelegate(new WhatIfDelegate(*model_, list_));
    list_->setAccessibleName(tr("What comes next"));
    list_->setUniformItemSizes(true);
    list_->setSelectionMode(QAbstractItemView::SingleSelection);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMinimumHeight(92);
    connect(list_, &QListView::clicked, this,
            [this](const QModelIndex& index) { chooseRow(index.row()); });
    connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& index) { chooseRow(index.row()); });
    layout->addWidget(list_, 1);
}

bool WhatIfBox::isFollowing() const {
    return follow_->isChecked();
}

void WhatIfBox::setFollowing(bool following) {
    follow_->setChecked(following);
}

void WhatIfBox::fillLabels() {
    const int mover = graph_.mover();
    title_->setText(tr("What next?"));
    title_->setToolTip(tr("What %1 may do next, the likeliest first").arg(fighterText(mover)));
    filling_ = true;
    for (QComboBox* box : {own_, opponent_})
        box->clear();
    if (graph_.hasGraph()) {
        const auto fill = [&](QComboBox* box, int player) {
            box->addItem(tr("anything"), kAnyNode);
            for (int node = 0; node < graph_.graph().nodeCount(player); ++node) {
                const QString name = graph_.nameOf(player, node);
                box->addItem(name, node);
                box->setItemData(box->count() - 1, name, Qt::ToolTipRole);
            }
        };
        fill(own_, mover);
        fill(opponent_, 1 - mover);
    }
    filling_ = false;
    if (isFollowing()) {
        followPlayhead();
    } else {
        rank();
    }
}

void WhatIfBox::followPlayhead() {
    if (!graph_.hasGraph() || !isFollowing()) {
        model_->setActual(kAnyNode);
        return;
    }
    const int mover = graph_.mover();
    const GraphMoment& moment = graph_.moment(mover);
    filling_ = true;
    own_->setCurrentIndex(std::max(0, own_->findData(moment.decision.own)));
    opponent_->setCurrentIndex(std::max(0, opponent_->findData(moment.decision.opponent)));
    filling_ = false;
    show(moment.decision, moment.next);
}

void WhatIfBox::show(const Moment& decision, int actual) {
    filling_ = true;
    const int mover = graph_.mover();
    model_->show(mover, graph_.candidates(mover, decision), decision.numbers.size() > 0);
    model_->setActual(actual);
    filling_ = false;
}

void WhatIfBox::followSelection() {
    const auto& selection = graph_.selection();
    if (!graph_.hasGraph() || !selection || selection->mover != model_->mover()) {
        list_->clearSelection();
        return;
    }
    // A cell that is chosen by hand is a question: what else might have come?
    const bool asked = !isFollowing() || !graph_.session().transport().isPlaying();
    const bool picked = selection->filter.own != kAnyNode || selection->filter.opponent != kAnyNode;
    if (asked && picked && !list_->hasFocus()) {
        setFollowing(false);
        filling_ = true;
        own_->setCurrentIndex(std::max(0, own_->findData(selection->filter.own)));
        opponent_->setCurrentIndex(std::max(0, opponent_->findData(selection->filter.opponent)));
        filling_ = false;
        rank();
    }
    const int row = model_->rowOf(selection->filter.next);
    filling_ = true;
    if (row >= 0) {
        list_->setCurrentIndex(model_->index(row));
    } else {
        list_->clearSelection();
    }
    filling_ = false;
}

void WhatIfBox::rank() {
    if (!graph_.hasGraph()) return;
    const int own = own_->currentData().toInt();
    const int opponent = opponent_->currentData().toInt();
    // A transition that is looked at knows where both stood.
    const auto current = graph_.current();
    if (current && current->mover == graph_.mover()) {
        const Transition& t = graph_.transitionOf(*current);
        if (t.ownNode == own && t.opponentNode == opponent) {
            show(graph_.decisionOf(*current), t.nextNode);
            return;
        }
    }
    Moment asked;
    asked.own = own;
    asked.opponent = opponent;
    show(asked, kAnyNode);
}

void WhatIfBox::chooseRow(int row) {
    if (filling_ || row < 0 || row >= model_->rowCount()) return;
    const int next = model_->rows()[static_cast<std::size_t>(row)].node;
    graph_.select(GraphSelection{
        model_->mover(), {own_->currentData().toInt(), opponent_->currentData().toInt(), next}});
}

}  // namespace kumite::studio
