#pragma once

#include <QObject>

#include <memory>

#include "studio/app/main_window.h"

namespace kumite::studio {

class Recovery;

/// Keeps the studio's window and its recovery copies. Where another language is chosen it puts a
/// new window in its place, with the same project, history and view: all texts are made anew.
class WindowKeeper : public QObject {
    Q_OBJECT

public:
    WindowKeeper();
    ~WindowKeeper() override;

    /// The window that is shown; another one after `replaced`.
    MainWindow& window() { return *window_; }
    /// From now on copies of unsaved work are kept.
    void keepCopies();

Q_SIGNALS:
    void replaced();

private:
    void listen();
    void followLanguage();
    void replace();
    std::unique_ptr<Recovery> makeRecovery(MainWindow& window);

    std::unique_ptr<MainWindow> window_;
    std::unique_ptr<Recovery> recovery_;
    QString language_;  ///< of the preferences, as the window was made
    bool due_ = false;
};

}  // namespace kumite::studio
