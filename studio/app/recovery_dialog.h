#pragma once

#include <QDialog>

#include <vector>

#include "studio/app/recovery.h"

class QPushButton;
class QTreeWidget;

namespace kumite::studio {

/// Offers what an unexpected end left behind: which project, when its last edit was made, how many
/// edits are not in its file. Closing it keeps everything for the next start.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    RecoveryDialog(std::vector<RecoveryCopy> copies, QWidget* parent);

Q_SIGNALS:
    void recoveryWanted(const RecoveryCopy& copy);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void recover();
    void discard();
    int chosen() const;

    std::vector<RecoveryCopy> copies_;
    QTreeWidget* list_;
    QPushButton* recover_;
    QPushButton* discard_;
};

}  // namespace kumite::studio
