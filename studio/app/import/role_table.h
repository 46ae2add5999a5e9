#pragma once

#include <QWidget>

#include <string>
#include <utility>
#include <vector>

#include "studio/app/import/import_look.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace kumite::studio {

/// Which joint plays which role, for both fighters: what was found and by which rule, and what the
/// user says instead.
class RoleTable : public QWidget {
    Q_OBJECT

public:
    using Mended = std::vector<std::pair<Role, std::string>>;

    explicit RoleTable(QWidget* parent = nullptr);

    void setLook(const ImportLook& look);
    /// What the user said, as a request wants it.
    const Mended& mended(int player) const { return mended_[player]; }
    /// Another recording: what was said of the last one is forgotten.
    void forget(int player) { mended_[player].clear(); }
    void swapFighters();
    /// Roles that have no joint, of both fighters, those apart that nothing needs.
    int missing() const { return missing_; }

Q_SIGNALS:
    void changed();

private:
    void fillColumn(int player, const Fighter& fighter);
    void choose(int player, Role role, const QString& joint);

    QLabel* rule_;
    QTableWidget* table_;
    Mended mended_[2];
    int missing_ = 0;
};

}  // namespace kumite::studio
