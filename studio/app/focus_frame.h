#pragma once

#include <QFrame>

namespace kumite::studio {

/// A thin frame in a drawn view that shows where keys go, once the keyboard has led there. After a
/// click it would only disturb. Belongs to the view.
class FocusFrame : public QFrame {
    Q_OBJECT

public:
    explicit FocusFrame(QWidget* view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace kumite::studio
