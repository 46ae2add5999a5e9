#include "studio/app/document.h"

#include <QFileInfo>

#include <exception>

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
}

QString Document::name() const {
    if (!path_.isEmpty()) return QFileInfo(path_).fileName();
    if (!open_ || project().takes.empty()) return {};
    return QString::fromStdString(project().takes.front().name);
}

void Document::open(History history, Analysis analysis, const QString& path, bool unsaved) {
    jobs_.cancel();
    history_ = std::move(history);
    analysis_ = std::move(analysis);
    path_ = path;
    unsaved_ = unsaved;
    open_ = true;
    endGesture();
    Q_EMIT opened();
    Q_EMIT analysisChanged();
    Q_EMIT changed();
}

void Document::markSaved(const QString& path) {
    path_ = path;
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
        Q_EMIT failed(QString::fromUtf8(error.what()));
        return false;
    }
    refresh();
    return true;
}

bool Document::apply(const ProjectEdit& edit) {
    return commit([&] { return edit(project()); });
}

bool Document::apply(const BoundaryEdit& edit) {
    return commit([&] {
        bringUpToDate();
        return edit(project(), analysis_);
    });
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
        Q_EMIT failed(QString::fromUtf8(error.what()));
        return false;
    }
    if (history_.position() != gestureStep_) endGesture();
    refresh();
    return true;
}

void Document::undo() {
    if (!history_.canUndo()) return;
    history_.undo();
    refresh();
}

void Document::redo() {
    if (!history_.canRedo()) return;
    history_.redo();
    refresh();
}

void Document::goToStep(std::size_t step) {
    if (step == history_.position()) return;
    history_.goTo(step);
    refresh();
}

void Document::bringUpToDate() {
    if (!isCurrent()) analyseNow();
}

void Document::analyseNow() {
    jobs_.cancel();
    try {
        analysis_ = analyse(project(), analysis_);
    } catch (const std::exception& error) {
        Q_EMIT failed(QString::fromUtf8(error.what()));
    }
    Q_EMIT analysisChanged();
}

void Document::refresh() {
    if (isQuick(analysis_, project())) {
        analyseNow();
    } else {
        jobs_.start(
            tr("Computing force curves"),
            [project = project(), previous = analysis_](const Progress& progress) {
                return analyse(project, previous, progress);
            },
            [this](Analysis analysis) {
                analysis_ = std::move(analysis);
                Q_EMIT analysisChanged();
                Q_EMIT changed();
            });
    }
    Q_EMIT changed();
}

}  // namespace kumite::studio
