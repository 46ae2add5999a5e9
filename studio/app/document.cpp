#include "studio/app/document.h"

#include <QFileInfo>

#include <exception>

namespace kumite::studio {

namespace {

/// Whether nothing but corrections and notes differs from what was analysed: such an analysis takes
/// milliseconds.
bool onlyCorrectionsDiffer(const Analysis& analysis, const Project& project) {
    if (!(analysis.settings == project.segmentation) ||
        !(analysis.bodyModel == project.bodyModel) ||
        analysis.takes.size() != project.takes.size()) {
        return false;
    }
    for (std::size_t take = 0; take < project.takes.size(); ++take) {
        const auto& fighters = project.takes[take].fighters;
        if (analysis.takes[take].size() != fighters.size()) return false;
        for (std::size_t player = 0; player < fighters.size(); ++player) {
            Fighter seen = analysis.takes[take][player].input;
            seen.corrections = fighters[player].corrections;
            seen.notes = fighters[player].notes;
            if (!(seen == fighters[player])) return false;
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
    Q_EMIT opened();
    Q_EMIT analysisChanged();
    Q_EMIT changed();
}

void Document::markSaved(const QString& path) {
    path_ = path;
    unsaved_ = false;
    history_.markSaved();
    Q_EMIT changed();
}

bool Document::commit(const std::function<MaybeEdit()>& edit, bool amends) {
    try {
        MaybeEdit result = edit();
        if (!result) return false;
        if (amends) {
            history_.amend(std::move(*result));
        } else {
            history_.commit(std::move(*result));
        }
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

bool Document::amend(const ProjectEdit& edit) {
    return commit([&] { return edit(project()); }, true);
}

bool Document::apply(const BoundaryEdit& edit) {
    return commit([&] {
        bringUpToDate();
        return edit(project(), analysis_);
    });
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
    if (onlyCorrectionsDiffer(analysis_, project())) {
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
