#pragma once

#include <QWidget>

class QGridLayout;
class QLabel;

namespace kumite::studio {

class Session;

/// How far the review of the shown take has come, per fighter and together.
class StatisticsBox : public QWidget {
    Q_OBJECT

public:
    explicit StatisticsBox(const Session& session, QWidget* parent);

    void refresh();

private:
    static constexpr int kRows = 3;
    static constexpr int kColumns = 5;

    const Session& session_;
    QLabel* cells_[kRows][kColumns] = {};
};

}  // namespace kumite::studio
