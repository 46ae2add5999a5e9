#pragma once

#include <QWidget>

#include <functional>
#include <vector>

class QPainter;

namespace kumite::studio {

class LabelReview;

/// Everything that a key says, with the keys in force: the aspects with their values of the
/// current action, the classes of the chosen lane, and the quick labels. A click does what the key
/// does; a right click on a class takes it as a brush.
class LabelPalette : public QWidget {
    Q_OBJECT

public:
    /// `keyOf`: the first key of a command, as people read it; empty without one.
    LabelPalette(LabelReview& review, std::function<QString(const QString& id)> keyOf,
                 QWidget* parent);

    void refresh();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    /// A part that can be clicked.
    struct Spot {
        enum Kind { Lane, Class, Quick, Besides, Caption } kind = Lane;
        int index = 0;
        QRect place;
        QString key;
        QString text;
        QString tip;
        QColor colour;
    };
    void layOut();
    void addClasses(int& top);
    void addQuick(int& top);
    void paintLane(QPainter& painter, const Spot& spot);
    void paintClass(QPainter& painter, const Spot& spot);
    void paintQuick(QPainter& painter, const Spot& spot);
    void paintBesides(QPainter& painter, const Spot& spot);
    const Spot* spotAt(const QPoint& position) const;

    LabelReview& review_;
    std::function<QString(const QString&)> keyOf_;
    std::vector<Spot> spots_;
    int height_ = 0;
    int quickTop_ = 0;
};

}  // namespace kumite::studio
