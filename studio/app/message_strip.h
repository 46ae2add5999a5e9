#pragma once

#include <QFrame>
#include <QStringList>

#include "core/base/finding.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace kumite::studio {

/// A message over the content that asks for nothing: an error's sentence, or what was found in
/// files. Stays until it is dismissed or replaced; longer lists open in a window of their own.
class MessageStrip : public QFrame {
    Q_OBJECT

public:
    explicit MessageStrip(QWidget* parent);

    void showError(const QString& sentence);
    /// Shows warnings; says nothing where there are none.
    void showFindings(const QString& about, const Findings& findings);
    void dismiss();
    QString text() const;

Q_SIGNALS:
    /// Findings were reported here, whether or not they were worth a message.
    void found(const QString& about, const Findings& findings);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void present(const QString& text, const QStringList& details);
    void place();
    void drawIcons();

    QLabel* icon_;
    QLabel* text_;
    QPushButton* more_;
    QToolButton* close_;
    QStringList details_;
    QString title_;
};

}  // namespace kumite::studio
