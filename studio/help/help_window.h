#pragma once

#include <QDialog>

#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QToolButton;

namespace kumite::studio {

class CommandTable;
class HelpView;

/// The help: contents and search at the left, the page at the right. Stays open beside the window.
/// Return in the search leads from place to place, and on to the next page that holds the words.
class HelpWindow : public QDialog {
    Q_OBJECT

public:
    HelpWindow(const CommandTable& commands, QWidget* parent);

    /// Shows a page, "method", or a place in it, "method#margin".
    void showPage(const QString& place);
    QString page() const { return page_; }
    /// Looks for words in all pages; only those that hold all of them stay in the contents.
    void search(const QString& words);

Q_SIGNALS:
    /// A link leads out of the help: an address of the web, or "command:help.tour".
    void followed(const QUrl& link);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fillContents();
    void open(const QString& page, const QString& anchor);
    void follow(const QUrl& link);
    void stepMark(int direction);
    void goBack(int direction);
    void showCounts();
    QStringList words() const;
    /// What is read of a page, for the search.
    const QString& plainText(std::size_t page);

    const CommandTable& commands_;
    QLineEdit* search_;
    QLabel* counts_;
    QListWidget* contents_;
    HelpView* view_;
    QToolButton* back_;
    QToolButton* on_;
    QString page_;
    QStringList visited_;  ///< places, the newest last
    qsizetype at_ = -1;    ///< among them
    std::vector<QString> plain_;
};

}  // namespace kumite::studio
