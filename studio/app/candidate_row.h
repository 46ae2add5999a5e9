#pragma once

#include <QColor>
#include <QList>
#include <QString>
#include <QStyleOptionViewItem>

class QPainter;

namespace kumite::studio {

/// A label that may come next, as lists show it on two lines: name and chance, then bars for the
/// terms that make the chance.
struct CandidateRow {
    struct Bar {
        QString text;
        double share = 0;  ///< 0 … 1
    };
    QString name;
    QString chance;        ///< at the right of the name
    bool isTaken = false;  ///< it was chosen or really came
    bool isFaint = false;  ///< it could not be taken
    QColor colour;         ///< of the bars
    QList<Bar> bars;
    QString count;  ///< at the right of the bars; empty: none
    bool isCountFaint = false;
};
void paintCandidateRow(QPainter& painter, const QStyleOptionViewItem& option,
                       const CandidateRow& row);
QSize candidateRowSize(const QStyleOptionViewItem& option);
/// "0.42", "<0.01": two digits tell candidates apart.
QString chanceText(double probability);

}  // namespace kumite::studio
