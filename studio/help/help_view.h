#pragma once

#include <QTextBrowser>

#include <vector>

namespace kumite::studio {

/// A page of the help, laid out, with the words marked that are looked for.
class HelpView : public QTextBrowser {
    Q_OBJECT

public:
    explicit HelpView(QWidget* parent = nullptr);

    /// Shows Markdown, from its beginning (-1) or from one of its headings, counted from 0.
    void showText(const QString& markdown, int heading);

    /// Marks every place of every one of the words and shows the first.
    void mark(const QStringList& words);
    int markCount() const { return static_cast<int>(marks_.size()); }
    /// Which of the marks is the current one; -1 without any.
    int currentMark() const { return current_; }
    /// Shows the next mark (+1) or the one before (-1), round at the ends.
    void stepMark(int direction);

protected:
    void changeEvent(QEvent* event) override;

private:
    void dress();
    void goToHeading(int heading);
    void paintMarks();

    QStringList words_;
    std::vector<QTextCursor> marks_;
    int current_ = -1;
};

}  // namespace kumite::studio
