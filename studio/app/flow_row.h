#pragma once

#include <QLayout>

#include <vector>

namespace kumite::studio {

/// A row of buttons and boxes that goes on in a second line where the window is too narrow for its
/// words: other languages and larger text need more room.
class FlowRow : public QLayout {
public:
    explicit FlowRow(QWidget* parent = nullptr) : QLayout(parent) {}
    ~FlowRow() override;

    void addItem(QLayoutItem* item) override { items_.push_back(item); }
    /// Some pixels between what stands before and what comes after.
    void addSpacing(int pixels);
    int count() const override { return static_cast<int>(items_.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return arrange({0, 0, width, 0}, false); }
    QSize sizeHint() const override;
    /// One item to a line.
    QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    /// The height that the lines take; with `place` the items are put there.
    int arrange(const QRect& rect, bool place) const;

    std::vector<QLayoutItem*> items_;
};

}  // namespace kumite::studio
