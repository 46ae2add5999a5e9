#include "studio/app/import/role_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "studio/app/core_words.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {

/// Many good skeletons lack them, and nothing needs them.
bool isDispensable(Role role) {
    return role == Role::Spine || role == Role::LeftClavicle || role == Role::RightClavicle;
}

QString ruleText(const Survey& survey) {
    const QString family = QString::fromStdString(survey.roles.family);
    if (family == QLatin1String("topology")) return RoleTable::tr("read off the skeleton's shape");
    if (family == QLatin1String("none")) return RoleTable::tr("no human body found");
    return RoleTable::tr("by %1 names").arg(family);
}

}  // namespace

RoleTable::RoleTable(QWidget* parent)
    : QWidget(parent), rule_(new QLabel(this)), table_(new QTableWidget(kRoleCount, 2, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->addWidget(rule_);
    layout->addWidget(table_);
    rule_->setProperty("role", "second");
    rule_->setWordWrap(true);
    table_->setAccessibleName(tr("Joints of the roles"));
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->setDefaultSectionSize(26);
    table_->setToolTip(tr("Which joint of the recording is which part of the body"));
    table_->setTabKeyNavigation(false);  // Tab leads out of it again
    table_->setShowGrid(false);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setHorizontalHeaderLabels({tr("fighter 1"), tr("fighter 2")});
    QStringList names;
    for (const Role role : allRoles())
        names.append(roleWords(role));
    table_->setVerticalHeaderLabels(names);
}

void RoleTable::setLook(const ImportLook& look) {
    QStringList rules;
    missing_ = 0;
    const auto& fighters = look.imported.take.fighters;
    table_->setColumnCount(static_cast<int>(fighters.size()));
    for (std::size_t player = 0; player < fighters.size(); ++player) {
        rules.append(tr("Fighter %1: %2 of %3 roles, %4.")
                         .arg(player + 1)
                         .arg(fighters[player].roles.count())
                         .arg(kRoleCount)
                         .arg(ruleText(look.imported.surveys[player])));
        fillColumn(static_cast<int>(player), fighters[player]);
    }
    table_->setHorizontalHeaderLabels({tr("fighter 1"), tr("fighter 2")});
    rule_->setText(rules.join(QLatin1Char(' ')));
}

void RoleTable::fillColumn(int player, const Fighter& fighter) {
    QStringList joints{tr("none")};
    for (const Joint& joint : fighter.motion->skeleton->joints)
        joints.append(QString::fromStdString(joint.name));
    for (const Role role : allRoles()) {
        const int row = static_cast<int>(role);
        auto* box = qobject_cast<QComboBox*>(table_->cellWidget(row, player));
        if (box == nullptr) {
            box = new QComboBox(table_);
            box->setAccessibleName(tr("%1 of %2").arg(roleWords(role), fighterText(player)));
            // The wheel scrolls the table; it must not change a joint on the way.
            box->setFocusPolicy(Qt::StrongFocus);
            connect(box, &QComboBox::activated, this, [this, player, role, box](int index) {
                choose(player, role, index == 0 ? QString() : box->itemText(index));
            });
            table_->setCellWidget(row, player, box);
        }
        const QSignalBlocker quiet(box);
        if (box->count() != joints.size() || box->itemText(1) != joints.value(1)) {
            box->clear();
            box->addItems(joints);
        }
        const auto joint = fighter.roles[role];
        box->setCurrentIndex(joint ? *joint + 1 : 0);
        const bool byHand = std::any_of(mended_[player].begin(), mended_[player].end(),
                                        [&](const auto& entry) { return entry.first == role; });
        box->setToolTip(byHand ? tr("set by hand") : joint ? tr("found") : tr("not found"));
        QFont font = table_->font();
        font.setBold(byHand);
        box->setFont(font);
        if (!joint && !isDispensable(role)) ++missing_;
    }
}

void RoleTable::choose(int player, Role role, const QString& joint) {
    std::erase_if(mended_[player], [&](const auto& entry) { return entry.first == role; });
    mended_[player].emplace_back(role, joint.toStdString());
    Q_EMIT changed();
}

void RoleTable::swapFighters() {
    std::swap(mended_[0], mended_[1]);
}

}  // namespace kumite::studio
