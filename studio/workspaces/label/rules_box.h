#pragma once

#include <QWidget>

#include <memory>
#include <optional>

#include "core/labelling/rules.h"

class QLabel;

namespace kumite::studio {

class LabelSession;
class ValueField;
struct LearntLabels;

/// The thresholds of the rules: when a foot stands, and how fast an attack must close. They act
/// while a slider moves, one gesture is one step; beside them how many actions get another label,
/// and why the current one has its own.
class RulesBox : public QWidget {
    Q_OBJECT

public:
    explicit RulesBox(LabelSession& labels, QWidget* parent);

    /// What the last gesture changed: "move: 12 of 180 actions, react: none".
    QString changesText() const;

private:
    static constexpr int kFields = 6;

    RuleSettings settings() const;
    void choose();
    void act();
    void beginGesture();
    void endGesture();
    void showSettings();
    void showChanges();
    void showReasons();
    bool isDragged() const;
    void restore();

    LabelSession& labels_;
    ValueField* fields_[kFields] = {};
    QLabel* changes_;
    QLabel* reasons_;
    std::optional<RuleSettings> waiting_;         ///< chosen while values are still computed
    std::shared_ptr<const LearntLabels> before_;  ///< as the last gesture found it
    bool gesture_ = false;                        ///< one is going on
};

}  // namespace kumite::studio
