#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>

#include "studio/app/import/import_look.h"

namespace kumite::studio {

/// Both fighters of a request in one space, from above and from the side, and their distance over
/// time. Space plays, arrows step, a drag on the distance scrubs.
class ImportPreview : public QWidget {
    Q_OBJECT

public:
    explicit ImportPreview(QWidget* parent = nullptr);

    /// Null: nothing to show; `text` then says why.
    void setLook(std::shared_ptr<const ImportLook> look, const QString& text = {});
    double seconds() const { return seconds_; }
    bool isPlaying() const { return timer_.isActive(); }
    void togglePlaying();
    QSize sizeHint() const override { return {520, 420}; }

Q_SIGNALS:
    void playingChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void goTo(double seconds);
    void advance();
    QRectF viewRect(bool fromAbove) const;
    QRectF plotRect() const;
    void paintView(QPainter& painter, bool fromAbove) const;
    void paintPlot(QPainter& painter) const;

    std::shared_ptr<const ImportLook> look_;
    QString text_;
    double seconds_ = 0;
    QTimer timer_;
    QElapsedTimer clock_;
};

}  // namespace kumite::studio
