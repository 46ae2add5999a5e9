#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QStringListModel;

namespace kumite::studio {

class FoundList;
class LabelSession;

/// Finds actions by what is typed ("right kick up, machine, below 0.6"): says what it understood,
/// how many there are, lists them, leads from one to the next and chooses them all together.
class FindBox : public QWidget {
    Q_OBJECT

public:
    explicit FindBox(LabelSession& labels, QWidget* parent);

    QLineEdit* field() const { return field_; }
    FoundList& list() { return *list_; }
    /// Types a filter.
    void setText(const QString& text);
    /// Puts the caret into the field with its text selected.
    void focusField();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void find();
    void complete();

    LabelSession& labels_;
    QLineEdit* field_;
    QStringListModel* offers_;
    QLabel* understood_;
    FoundList* list_;
    QPushButton* all_;
};

}  // namespace kumite::studio
