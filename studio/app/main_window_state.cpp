// Handing over to another window, in another language.

#include <QStackedWidget>

#include "studio/app/file_actions.h"
#include "studio/app/main_window.h"

namespace kumite::studio {

WindowState MainWindow::handOver() {
    // The next window reads where its parts stand.
    saveLayout();
    session_.transport().setPlaying(false);
    files_->finishEdits();
    const Document& document = session_.document();
    if (!document.isOpen()) return {};
    std::vector<FoundInFiles> findings = findings_.groups();
    // Found anew, under a title in the other language, once sequences are looked at again.
    std::erase_if(findings, [](const FoundInFiles& each) { return each.about == clipsTitle(); });
    return {WindowState::Opened{
        document.history(), document.analysis(), document.path(), document.isUnsaved(),
        document.onDisk(), files_->lock(), session_.take(), session_.activePlayer(),
        session_.transport().playhead(), session_.visible(), session_.selection(),
        session_.selectedAction(), std::move(findings)}};
}

void MainWindow::takeOver(WindowState state) {
    if (!state.opened) return;
    WindowState::Opened& was = *state.opened;
    files_->setLock(was.lock);
    session_.document().open(std::move(was.history), std::move(was.analysis), was.path, was.unsaved,
                             was.onDisk);
    for (const FoundInFiles& found : was.findings)
        findings_.add(found.about, found.findings);
    session_.setTake(was.take);
    session_.setActivePlayer(was.activePlayer);
    session_.transport().setPlayhead(was.playhead);
    session_.setVisible(was.visible);
    if (was.selection) {
        session_.select(was.selection);
    } else if (was.selectedAction) {
        session_.selectAction(was.selectedAction);
    }
}

}  // namespace kumite::studio
