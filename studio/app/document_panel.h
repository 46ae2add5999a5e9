#pragma once

#include <QWidget>

class QListWidget;

namespace kumite::studio {

class Session;

/// The left panel: takes, the fighters of the shown one, and the history of edits. A click goes
/// there.
class DocumentPanel : public QWidget {
    Q_OBJECT

public:
    explicit DocumentPanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void showTakes();
    void showFighters();
    void showHistory();

    Session& session_;
    QListWidget* takes_;
    QListWidget* fighters_;
    QListWidget* history_;
    bool filling_ = false;
};

}  // namespace kumite::studio
