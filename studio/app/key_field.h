#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace kumite::studio {

/// A field that shows the key that is pressed in it, whatever that key does elsewhere.
class KeyField : public QLineEdit {
    Q_OBJECT

public:
    explicit KeyField(QWidget* parent = nullptr);

    QKeySequence key() const { return key_; }
    void setKey(const QKeySequence& key);

Q_SIGNALS:
    void keyChanged();

protected:
    bool event(QEvent* event) override;

private:
    QKeySequence key_;
};

/// The key of a key press as commands name it; empty for a modifier alone.
QKeySequence keyOf(Qt::KeyboardModifiers modifiers, int key, const QString& text);

}  // namespace kumite::studio
