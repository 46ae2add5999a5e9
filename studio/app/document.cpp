#include "studio/app/document.h"

#include <QFileInfo>

#include <exception>
#include <utility>

#include "studio/app/core_words.h"

namespace kumite::studio {

namespace {

/// Whether every fighter was analysed with all that its curves are made from, wherever it stood:
/// then the analysis takes milliseconds. Corrections, notes, labels, offsets, placements and the
/// order of takes and fighters are such changes.
bool isQuick(const Analysis& analysis, const Project& project) {
    if (!(analysis.settings == project.segmentation) ||
        !(analysis.bodyModel == project.bodyModel) ||
        !(analysis.contacts == project.labelling.rules.contacts)) {
        return false;
    }
    const auto isKnown = [&](const Fighter& fighter) {
        for (const auto& take : analysis.takes) {
            for (const FighterAnalysis& known : take) {
                Fighter seen = known.input;
                seen.corrections = fighter.corrections;
                seen.notes = fighter.notes;
                seen.labels = fighter.labels;
                seen.offset = fighter.offset;
                seen.placement = fighter.placement;
                if (seen == fighter) return true;
            }
        }
        return false;
    };
    for (const Take& take : project.takes) {
        for (const Fighter& fighter : take.fighters) {
            if (!isKnown(fighter)) return false;
        }
    }
    return true;
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent) {
    connect(&jobs_, &JobRunner::failed, this, &Document::failed);
    connect(&jobs_, &JobRunner::finished, this, [this] {
        // Told before the result is handed over; a job that was cancelled or failed has none.
        const auto look = [this] {
            if (!isCurrent() && !isComputing()) dropWaiting();
        };
        QMetaObject::invokeMethod(this, look, Qt::QueuedConnection);
    });
}

QString Document::name() const {
    if (!path_.isEmpty()) return QFileInfo(path_).fileName();
    if (!open_ || project().takes.empty()) return {};
    return QString::fromStdString(project().takes.front().name);
}

void Document::open(History history, Analysis analysis, const QString& path, bool unsaved,
                    std::string onDisk) {
    jobs_.cancel();
    waiting_.clear();
    history_ = std::move(history);
    analysis_ = std::move(analysis);
    current_ = true;
    path_ = path;
    onDisk_ = std::move(onDisk);
    unsaved_ = unsaved;
    open_ = true;
    endGesture();
    Q_EMIT opened();
    Q_EMIT analysisChanged();
    Q_EMIT changed();
}

void Document::markSaved(const QString& path, std::string onDisk) {
    path_ = path;
    onDisk_ = std::move(onDisk);
    unsaved_ = false;
    history_.markSaved();
    endGesture();
    Q_EMIT changed();
}

bool Document::commit(const std::function<MaybeEdit()>& edit) {
    endGesture();
    try {
        MaybeEdit result = edit();
        if (!result) return false;
        history_.commit(std::move(*result));
    } catch (const std::exception& error) {
        Q_EMIT failed(coreWords(error.what()));
        return false;
    }
    refresh();
    return true;
}

bool Document::apply(const ProjectEdit& edit) {
    return commit([&] { return edit(project()); });
}

bool Document::apply(const BoundaryEdit& edit) {
    if (!isCurrent()) {
        Q_EMIT failed(tr("The force curves are still being computed; try again in a moment."));
        return false;
    }
    return commit([&] { return edit(project(), analysis_); });
}

void Document::whenCurrent(const std::function<void()>& act) {
    if (isCurrent()) {
        act();
        return;
    }
    waiting_.push_back(act);
    if (!isComputing()) refresh();
    Q_EMIT changed();
}

bool Document::applyLive(const QString& gesture, const ProjectEdit& edit) {
    const bool goesOn = gesture == gesture_ && history_.position() == gestureStep_ &&
                        history_.canUndo() && !history_.canRedo();
    if (!goesOn) {
        const bool applied = apply(edit);
        if (applied) {
            gesture_ = gesture;
            gestureStep_ = history_.position();
        }
        return applied;
    }
    try {
        const Project& before = history_.steps()[history_.position() - 1].project;
        const MaybeEdit result = edit(before);
        history_.amend(result ? *result : Edit{before, {}});
    } catch (const std::exception& error) {
        Q_EMIT failed(coreWords(error.what()));
        return false;
    }
    if (history_.position() != gestureStep_) endGesture();
    refresh();
    return true;
}

void Document::step(const std::function<void()>& move) {
    const Project before = project();
    move();
    refresh();
    Q_EMIT stepped(before);
}

void Document::undo() {
    if (isWaiting()) {
        waiting_.pop_back();
        Q_EMIT changed();
        return;
    }
    if (history_.canUndo()) step([this] { history_.undo(); });
}

void Document::redo() {
    if (canRedo()) step([this] { history_.redo(); });
}

void Document::goToStep(std::size_t to) {
    dropWaiting();
    if (to != history_.position()) step([&] { history_.goTo(to); });
}

void Document::takeOver(Analysis analysis) {
    analysis_ = std::move(analysis);
    current_ = true;
    Q_EMIT analysisChanged();
}

void Document::analyseNow() {
    jobs_.cancel();
    current_ = false;
    try {
        takeOver(analyse(project(), analysis_));
    } catch (const std::exception& error) {
        Q_EMIT failed(coreWords(error.what()));
    }
}

void Document::runWaiting() {
    if (!isCurrent()) {
        if (!isComputing()) dropWaiting();
        return;
    }
    // What these edits make may have to be computed beside the window again: the rest waits on.
    const auto acts = std::exchange(waiting_, {});
    for (const auto& act : acts)
        whenCurrent(act);
}

void Document::dropWaiting() {
    if (!isWaiting()) return;
    waiting_.clear();
    Q_EMIT changed();
}

void Document::refresh() {
    if (isQuick(analysis_, project())) {
        analyseNow();
        Q_EMIT changed();
        runWaiting();
    } else {
        current_ = false;
        jobs_.start(
            tr("Computing force curves"),
            [project = project(), previous = analysis_](const Progress& progress) {
                return analyse(project, previous, progress);
            },
            [this](Analysis analysis) {
                takeOver(std::move(analysis));
                Q_EMIT changed();
                runWaiting();
            });
        Q_EMIT changed();
    }
}

}  // namespace kumite::studio
