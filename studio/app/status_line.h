#pragma once

#include <QLabel>
#include <QStringList>
#include <QTimer>

namespace kumite::studio {

/// The line at the bottom of the window. It shows what was said last, while that holds; else what
/// the pointer is on; else what the keys do now.
class StatusLine : public QLabel {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// What the keys do now, the most useful first; where there is no room for all the later ones
    /// are left out, but never the last.
    void setKeys(const QStringList& parts);
    /// What the pointer is on; empty: nothing.
    void setPointer(const QString& text);
    /// What was done, or why something was not: until the next thing is done, or some seconds long.
    /// Empty: what was said does not hold any more.
    void say(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    QString fittingKeys() const;

    QStringList keys_;
    QString pointer_, said_;
    QTimer fading_;
};

}  // namespace kumite::studio
