#include "studio/app/questions.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>

#include <cstdio>

namespace kumite::studio {

namespace {

bool attended = true;

/// Translations of this file.
QString text(const char* source) {
    return QCoreApplication::translate("kumite::studio::Questions", source);
}

/// With nobody there says that no file is chosen.
bool mayAskForFile(const QString& title) {
    if (!attended) tell(text("%1: nobody is here to choose a file.").arg(title));
    return attended;
}

}  // namespace

void setAttended(bool is) {
    attended = is;
}

bool isAttended() {
    return attended;
}

void tell(const QString& sentence) {
    std::fprintf(stderr, "kumite-studio: %s\n", qPrintable(sentence));
}

QAbstractButton* answerOf(QMessageBox& box, QAbstractButton* unattended) {
    if (attended) {
        box.exec();
        return box.clickedButton();
    }
    tell(text("%1 Nobody is here to answer: %2.")
             .arg(box.text(), unattended->text().remove(QLatin1Char('&'))));
    return unattended;
}

void notify(QWidget* parent, const QString& title, const QString& words) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, words, QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

QString fileToOpen(QWidget* parent, const QString& title, const QString& folder,
                   const QString& filter) {
    if (!mayAskForFile(title)) return {};
    return QFileDialog::getOpenFileName(parent, title, folder, filter);
}

QStringList filesToOpen(QWidget* parent, const QString& title, const QString& folder,
                        const QString& filter) {
    if (!mayAskForFile(title)) return {};
    return QFileDialog::getOpenFileNames(parent, title, folder, filter);
}

QString fileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                   const QString& filter, QString* chosenFilter) {
    if (!mayAskForFile(title)) return {};
    return QFileDialog::getSaveFileName(parent, title, suggestion, filter, chosenFilter);
}

}  // namespace kumite::studio
