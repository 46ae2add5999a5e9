#pragma once

#include <QObject>
#include <QPointer>

class QUrl;

namespace kumite::studio {

class CommandTable;
class HelpWindow;
class MainWindow;
class Tour;

/// What helps in a window: the pages, what's-this for everything, the tour.
class Help : public QObject {
    Q_OBJECT

public:
    explicit Help(MainWindow& window);
    ~Help() override;

    /// The entries of the menu Help.
    void addCommands(CommandTable& commands, const QString& menu);

    /// Opens a page, "segment", or a place in it, "method#margin".
    void open(const QString& place);
    /// The page of the workspace that is shown; without a bout the first steps.
    void openHere();
    /// Says what has the focus, beside it.
    void describeFocus();
    Tour& tour() { return *tour_; }

protected:
    /// What's-this of any widget, and F1 in the pages beside the window.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(const QUrl& link);

    MainWindow& window_;
    QPointer<HelpWindow> page_;
    Tour* tour_;
};

}  // namespace kumite::studio
