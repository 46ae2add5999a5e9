#pragma once

#include <QString>

class QAbstractButton;
class QMessageBox;
class QWidget;

namespace kumite::studio {

/// Whether somebody is there to answer what the studio asks. Pictures, scripts and the opening of
/// a watched run go on by themselves: what would be asked is said on standard error, with the
/// answer that is taken, and nothing waits.
void setAttended(bool attended);
bool isAttended();
/// A sentence on standard error.
void tell(const QString& sentence);

/// Shows the box until it is answered and gives the button; with nobody there, `unattended` (one
/// of its buttons), at once.
QAbstractButton* answerOf(QMessageBox& box, QAbstractButton* unattended);
/// Says something that needs no answer and does not wait.
void notify(QWidget* parent, const QString& title, const QString& text);

/// Asks for a file to read, several, or one to write, as QFileDialog does; with nobody there none
/// is chosen.
QString fileToOpen(QWidget* parent, const QString& title, const QString& folder,
                   const QString& filter);
QStringList filesToOpen(QWidget* parent, const QString& title, const QString& folder,
                        const QString& filter);
QString fileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                   const QString& filter, QString* chosenFilter = nullptr);

}  // namespace kumite::studio
