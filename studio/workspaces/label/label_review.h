#pragma once

#include <QObject>

#include <optional>
#include <utility>
#include <vector>

#include "studio/workspaces/label/label_session.h"

namespace kumite::studio {

/// A qualifier that the pointer or a held key paints over actions.
struct Brush {
    int aspect = 0;
    int qualifier = 0;

    bool operator==(const Brush&) const = default;
};

/// What hands do in the Label workspace: from question to question, one key each. An answer goes
/// on to the next question where that is switched on. With several actions chosen an answer is
/// meant for all of them.
class LabelReview : public QObject {
    Q_OBJECT

public:
    explicit LabelReview(LabelSession& labels, QObject* parent = nullptr);

    LabelSession& labels() { return labels_; }

    bool isAdvancing() const { return advancing_; }
    void setAdvancing(bool advancing);

    /// The next question of the queue after the current action; round at the end.
    void next();
    /// The one that was shown before.
    void previous();
    /// Shows an action and plays it in a loop.
    void show(const ShownAction& action);

    /// What is proposed is right.
    void accept();
    /// It is not: the second best instead; of what a hand has said, nothing any more.
    void reject();
    /// Takes back all that is said of the chosen actions.
    void clear();

    void stepLane(int direction);
    /// The qualifier with this key ("1" … "9", "0") in the chosen lane.
    std::optional<int> qualifierOf(int digit) const;
    void nameClass(int digit);
    /// The same for a qualifier of the chosen lane by its index.
    void nameQualifier(int qualifier);
    /// A whole label at once, by its place among the quick labels.
    void quick(int index);
    /// The next class key comes beside what strikes already: a composite.
    bool isComposite() const { return composite_; }
    void setComposite(bool composite);
    /// The same as a switch. Between the first and the second of two classes it stays on.
    void announceBesides();

    /// Chooses one action more, before (-1) or after (+1) the current one.
    void extend(int direction);
    /// Chooses from the action that was chosen first to this one, of the same fighter.
    void extendTo(const ActionRef& action);
    /// Chooses it besides, or no longer.
    void toggle(const ActionRef& action);

    const std::optional<Brush>& brush() const { return brush_; }
    void setBrush(std::optional<Brush> brush);
    /// Paints with the brush, else with the class whose key is held; one step of the history until
    /// `endPainting`. False where there is nothing to paint with.
    bool paint(const ActionRef& action);
    void endPainting();

    /// Accepts all that is at least so sure, as soon as that is known.
    void acceptSure(double leastConfidence);

Q_SIGNALS:
    /// Advance, brush or composite were switched.
    void switched();
    /// An action is looked at: the camera should show both fighters.
    void shown();

protected:
    /// Learns when a held key is let go.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Whether what is said now is the first of two classes that were announced.
    bool isFirstOfTwo() const;
    void answered(bool changed, bool firstOfTwo = false);
    void lookAtLeastSure();
    void tellAccepted(double leastConfidence);
    void paintAtPlayhead();

    LabelSession& labels_;
    bool advancing_ = true;
    bool composite_ = false;
    std::optional<Brush> brush_;
    std::optional<Brush> held_;
    std::vector<std::pair<FighterAddress, int>> visited_;  ///< by peaks
    std::optional<double> sureWanted_;  ///< asked for while it was still being computed
};

}  // namespace kumite::studio
