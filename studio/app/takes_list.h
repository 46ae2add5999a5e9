#pragma once

#include <QListWidget>

namespace kumite::studio {

class Session;

/// The takes of the project: a click shows one, a double-click or F2 renames it where it stands,
/// and a drag puts it elsewhere.
class TakesList : public QListWidget {
    Q_OBJECT

public:
    explicit TakesList(Session& session, QWidget* parent = nullptr);

    void refresh();
    void renameShown();
    bool isRenaming() const { return state() == EditingState; }
    /// Moves the shown take up (-1) or down (+1).
    void moveShown(int direction);
    void moveTo(int take, int place);
    /// The place that a take gets which is dropped at a point of the list.
    int placeAt(const QPoint& point) const;

protected:
    void dropEvent(QDropEvent* event) override;

private:
    void rename(QListWidgetItem* item);

    Session& session_;
    bool filling_ = false;
};

}  // namespace kumite::studio
