#pragma once

#include <QWidget>

#include <vector>

class QLabel;
class QStackedWidget;
class QToolButton;

namespace kumite::studio {

class CommandTable;
class CompareLabelsBox;
class FindBox;
class LabelPanel;
class LabelReview;
class QualityBox;
class RulesBox;
class SimilarBox;

/// The right panel of the Label workspace: the palette and queue first, beside it what looks at
/// labels in other ways. One page at a time; each is computed only while it is shown.
class LabelViews : public QWidget {
    Q_OBJECT

public:
    enum Page { LabelPage, FindPage, SimilarPage, QualityPage, RulesPage, ComparePage, PageCount };

    LabelViews(LabelReview& review, CommandTable& commands, QWidget* parent = nullptr);

    Page page() const;
    void setPage(Page page);
    QString pageName(Page page) const;

    LabelPanel& label() { return *label_; }
    FindBox& find() { return *find_; }
    SimilarBox& similar() { return *similar_; }
    QualityBox& quality() { return *quality_; }
    RulesBox& rules() { return *rules_; }
    CompareLabelsBox& comparison() { return *comparison_; }

Q_SIGNALS:
    void pageChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    void addPage(Page page, QWidget* content, const QString& icon, const QString& tip);
    void drawIcons();

    QStackedWidget* pages_;
    std::vector<QToolButton*> buttons_;
    LabelPanel* label_;
    FindBox* find_;
    SimilarBox* similar_;
    QualityBox* quality_;
    RulesBox* rules_;
    CompareLabelsBox* comparison_;
};

}  // namespace kumite::studio
