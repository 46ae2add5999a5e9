#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace kumite::studio {

/// The numbers that a slider runs over: finer at the low end, where settings matter most.
struct SliderScale {
    double low = 0;
    double high = 1;
    int steps = 400;

    double valueAt(int step) const;
    int stepOf(double value) const;
};

/// A number as a slider and a field beside each other. Both act at once.
class ValueField : public QWidget {
    Q_OBJECT

public:
    struct Look {
        QString name;  ///< for assistive programs
        QString toolTip;
        QString suffix;
        int decimals = 2;
        double step = 0.01;  ///< of the field
        double highest = 1;  ///< that the field takes
    };

    ValueField(const SliderScale& scale, const Look& look, QWidget* parent);

    double value() const { return value_; }
    /// Shows a value; says nothing.
    void setValue(double value);
    /// Whether a hand holds the slider.
    bool isDragged() const;

Q_SIGNALS:
    /// A hand chose another value; again and again while the slider moves.
    void chosen(double value);
    /// The slider was let go.
    void released();

private:
    void fieldEdited();

    SliderScale scale_;
    QSlider* slider_;
    QDoubleSpinBox* field_;
    double value_ = 0;
    bool showing_ = false;
};

}  // namespace kumite::studio
