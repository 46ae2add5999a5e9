#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QListView;
class QListWidget;

namespace kumite::studio {

class CommandTable;
class HistoryModel;
class Session;
class TakesList;

/// The left panel: takes, the fighters of the shown one, and the history of edits. A click goes
/// there.
class DocumentPanel : public QWidget {
    Q_OBJECT

public:
    explicit DocumentPanel(Session& session, QWidget* parent = nullptr);

    TakesList& takes() { return *takes_; }
    /// Buttons beside the headings and menus on the lists, once the commands are there.
    void addCommands(CommandTable& commands);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QHBoxLayout* addSection(const QString& title, QWidget* list);
    void refresh();
    void showFighters();
    void showHistory();

    Session& session_;
    TakesList* takes_;
    QLabel* noTakes_;
    QListWidget* fighters_;
    QListView* history_;
    HistoryModel* historyModel_;
    QHBoxLayout* takesHeading_ = nullptr;
    QHBoxLayout* fightersHeading_ = nullptr;
    bool filling_ = false;
};

}  // namespace kumite::studio
