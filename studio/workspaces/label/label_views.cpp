#include "studio/workspaces/label/label_views.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "studio/app/icons.h"
#include "studio/app/panel_parts.h"
#include "studio/app/theme.h"
#include "studio/workspaces/label/compare_labels_box.h"
#include "studio/workspaces/label/find_box.h"
#include "studio/workspaces/label/label_panel.h"
#include "studio/workspaces/label/label_review.h"
#include "studio/workspaces/label/quality_box.h"
#include "studio/workspaces/label/rules_box.h"
#include "studio/workspaces/label/similar_box.h"

namespace kumite::studio {

LabelViews::LabelViews(LabelReview& review, CommandTable& commands, QWidget* parent)
    : QWidget(parent),
      pages_(new QStackedWidget(this)),
      label_(new LabelPanel(review, commands, this)),
      find_(new FindBox(review.labels(), this)),
      similar_(new SimilarBox(review.labels(), this)),
      quality_(new QualityBox(review.labels(), this)),
      rules_(new RulesBox(review.labels(), this)),
      comparison_(new CompareLabelsBox(review.labels(), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(0);
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(8, 0, 8, 0);
    row->setSpacing(2);
    auto* group = new QButtonGroup(this);
    for (int page = 0; page < PageCount; ++page) {
        auto* button = new QToolButton(bar);
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setIconSize({16, 16});
        group->addButton(button, page);
        row->addWidget(button);
        buttons_.push_back(button);
    }
    row->addStretch(1);
    layout->addWidget(bar);
    layout->addWidget(pages_, 1);
    connect(group, &QButtonGroup::idClicked, this, [this](int page) { setPage(Page(page)); });
    addPage(LabelPage, label_, QStringLiteral("label"), tr("Palette and questions"));
    addPage(FindPage, find_, QStringLiteral("find"), tr("Find actions by what is said of them"));
    addPage(SimilarPage, similar_, QStringLiteral("tiles"),
            tr("Actions that look like the current one, side by side"));
    addPage(QualityPage, quality_, QStringLiteral("quality"),
            tr("How well the machine knows the bout: confusion matrix and learning curve"));
    addPage(RulesPage, rules_, QStringLiteral("adjust"),
            tr("Thresholds of the rules for move and react"));
    addPage(ComparePage, comparison_, QStringLiteral("compare"),
            tr("Another person's labels beside these"));
    drawIcons();
    setPage(LabelPage);
}

void LabelViews::addPage(Page page, QWidget* content, const QString& icon, const QString& tip) {
    QToolButton* button = buttons_[static_cast<std::size_t>(page)];
    button->setProperty("iconName", icon);
    button->setToolTip(tip);
    button->setAccessibleName(pageName(page));
    if (page == LabelPage) {
        pages_->addWidget(content);
        return;
    }
    // A low window scrolls the page instead of growing.
    auto* scroll = new QScrollArea(pages_);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* frame = new QWidget(scroll);
    auto* layout = new QVBoxLayout(frame);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(5);
    auto* heading = headingLabel(pageName(page), frame);
    layout->addWidget(heading);
    layout->addWidget(content, 1);
    scroll->setWidget(frame);
    pages_->addWidget(scroll);
}

QString LabelViews::pageName(Page page) const {
    const QString names[] = {tr("Label"),   tr("Find actions"), tr("Similar actions"),
                             tr("Quality"), tr("Rules"),        tr("Two people")};
    return names[page];
}

LabelViews::Page LabelViews::page() const {
    return static_cast<Page>(pages_->currentIndex());
}

void LabelViews::setPage(Page page) {
    pages_->setCurrentIndex(page);
    buttons_[static_cast<std::size_t>(page)]->setChecked(true);
    Q_EMIT pageChanged();
}

void LabelViews::drawIcons() {
    const Colours& c = coloursFor(palette());
    for (QToolButton* button : buttons_)
        button->setIcon(lineIcon(button->property("iconName").toString(), c.text));
}

void LabelViews::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) drawIcons();
    QWidget::changeEvent(event);
}

}  // namespace kumite::studio
