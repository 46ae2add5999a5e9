#include "studio/app/questions.h"

#include "studio/app/language.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>

#include <cstdio>

namespace kumite::studio {

namespace {

bool attended = true;

/// Translations of this file.
struct Questions {
    Q_DECLARE_TR_FUNCTIONS(kumite::studio::Questions)
};

/// With nobody there says that no file is chosen.
bool mayAskForFile(const QString& title) {
    if (!attended) tell(Questions::tr("%1: nobody is here to choose a file.").arg(title));
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
    tell(Questions::tr("%1 Nobody is here to answer: %2.")
             .arg(box.text(), withoutMnemonic(unattended->text())));
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
