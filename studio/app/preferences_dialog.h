#pragma once

#include <QDialog>

class QTabWidget;

namespace kumite::studio {

class CommandTable;
class Preferences;

/// The preferences: everything takes effect while it is changed.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    enum Page { GeneralPage, KeysPage };

    PreferencesDialog(Preferences& preferences, CommandTable& commands, QWidget* parent);
    void showPage(Page page);

private:
    QWidget* makeGeneralPage();

    Preferences& preferences_;
    QTabWidget* pages_;
};

}  // namespace kumite::studio
