#pragma once

#include <QWidget>

class QLabel;
class QListWidget;

namespace kumite {
struct TransitionReport;
}

namespace kumite::studio {

class DistanceGridView;
class SequenceSession;

/// The transition to the chosen block: what it was made of, what else there would be, and where
/// the motions were joined. A click takes an alternative.
class TransitionBox : public QWidget {
    Q_OBJECT

public:
    explicit TransitionBox(SequenceSession& sequence, QWidget* parent = nullptr);

    /// How a transition goes, in words: "on a curve".
    static QString wayOf(const TransitionReport& report);

private:
    void refresh();
    void take(int row);

    SequenceSession& sequence_;
    QLabel* text_;
    QListWidget* list_;
    DistanceGridView* grid_;
};

}  // namespace kumite::studio
