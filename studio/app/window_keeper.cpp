#include "studio/app/window_keeper.h"

#include <QApplication>
#include <QTimer>

#include "studio/app/file_actions.h"
#include "studio/app/language.h"
#include "studio/app/message_strip.h"
#include "studio/app/recovery.h"

namespace kumite::studio {

namespace {
constexpr int kPatience = 50;  // milliseconds between two looks at a busy window
}

WindowKeeper::WindowKeeper() : window_(std::make_unique<MainWindow>()) {
    listen();
}

WindowKeeper::~WindowKeeper() {
    // It listens to the window's session.
    recovery_.reset();
}

void WindowKeeper::listen() {
    language_ = window_->preferences().values().language;
    connect(&window_->preferences(), &Preferences::changed, this, &WindowKeeper::followLanguage);
}

std::unique_ptr<Recovery> WindowKeeper::makeRecovery(MainWindow& window) {
    auto recovery = std::make_unique<Recovery>(window.session());
    connect(recovery.get(), &Recovery::failed, &window.messages(), &MessageStrip::showError);
    // The old copy goes only once this run has one of its own, which the opening makes.
    connect(&window.files(), &FileActions::recovered, recovery.get(),
            [kept = recovery.get()](const RecoveryCopy& copy) {
                kept->countOn(copy.edits);
                Recovery::discard(copy);
            });
    const auto setInterval = [kept = recovery.get(), &window] {
        kept->setInterval(window.preferences().values().autosaveSeconds);
    };
    setInterval();
    connect(&window.preferences(), &Preferences::changed, recovery.get(), setInterval);
    return recovery;
}

void WindowKeeper::keepCopies() {
    recovery_ = makeRecovery(*window_);
}

void WindowKeeper::followLanguage() {
    if (due_ || window_->preferences().values().language == language_) return;
    due_ = true;
    // Not from within the field that chose it.
    QTimer::singleShot(0, this, &WindowKeeper::replace);
}

void WindowKeeper::replace() {
    if (window_->isBusy()) {
        QTimer::singleShot(kPatience, this, &WindowKeeper::replace);
        return;
    }
    due_ = false;
    const bool choosing = window_->isShowingPreferences();
    WindowState state = window_->handOver();
    useLanguage(window_->preferences().values().language);
    auto next = std::make_unique<MainWindow>();
    // The new window's copies are written before those of the old one go.
    auto recovery = recovery_ ? makeRecovery(*next) : nullptr;
    next->takeOver(std::move(state));
    next->setGeometry(window_->geometry());
    if (window_->isVisible()) next->show();
    window_->hide();
    recovery_ = std::move(recovery);
    window_.swap(next);
    listen();
    if (choosing) window_->showPreferences(PreferencesDialog::GeneralPage);
    Q_EMIT replaced();
    // The old one may still be on the way back from an event.
    next.release()->deleteLater();
}

}  // namespace kumite::studio
