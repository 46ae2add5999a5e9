#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <string>
#include <vector>

#include "core/project/analysis.h"
#include "core/project/edits.h"
#include "core/project/history.h"
#include "studio/jobs/job_runner.h"

namespace kumite::studio {

/// The open project with its undo history, and everything derived from it. All edits go through
/// here. Belongs to the GUI thread.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    bool isOpen() const { return open_; }
    const Project& project() const { return history_.current(); }
    const History& history() const { return history_; }
    /// The derived values; those of an earlier project while `isCurrent()` is false: a job computes
    /// them, or was cancelled.
    const Analysis& analysis() const { return analysis_; }
    bool isCurrent() const { return current_; }
    bool isComputing() const { return jobs_.isRunning(); }

    /// Absolute path of the project file; empty while it has none.
    QString path() const { return path_; }
    /// "bout.kumite", or the first take's name.
    QString name() const;
    /// It is not what its file holds, whatever the history says.
    bool isUnsaved() const { return unsaved_; }
    /// Edits that wait for the derived values count.
    bool isModified() const { return open_ && (unsaved_ || !history_.isSaved() || isWaiting()); }

    /// What the file held when it was last read or written here, as `fingerprint` tells: another
    /// content there is somebody else's. Empty where there is no such file.
    const std::string& onDisk() const { return onDisk_; }

    /// Makes a project the open one. `unsaved`: it is not what the file at `path` holds.
    void open(History history, Analysis analysis, const QString& path, bool unsaved,
              std::string onDisk = {});
    void markSaved(const QString& path, std::string onDisk = {});

    using ProjectEdit = std::function<MaybeEdit(const Project&)>;
    using BoundaryEdit = std::function<MaybeEdit(const Project&, const Analysis&)>;
    /// Commits what the function returns; false where it changed nothing or failed (then
    /// `failed` says why).
    bool apply(const ProjectEdit& edit);
    /// The same for edits that need the derived values of the very project. While these are being
    /// computed there is no such edit (`failed` says so): see `whenCurrent`.
    bool apply(const BoundaryEdit& edit);
    /// Runs what needs the derived values: at once where they are current, else as soon as they
    /// are, so that nobody waits for a long analysis. What was asked first runs first; undo takes
    /// back what was asked last; another project, a step in the history and a cancelled analysis
    /// drop all.
    void whenCurrent(const std::function<void()>& act);
    bool isWaiting() const { return !waiting_.empty(); }
    /// For values that follow a hand: edits one after the other under the same name of a gesture
    /// ("offset of fighter 1") are one step of the history, made from the project before it; led
    /// back to where it began, there is no step. See History::amend.
    bool applyLive(const QString& gesture, const ProjectEdit& edit);
    /// The next edit is a step of its own.
    void endGesture() { gesture_.clear(); }
    bool canUndo() const { return isWaiting() || history_.canUndo(); }
    /// Nothing can be redone while a newer edit waits.
    bool canRedo() const { return !isWaiting() && history_.canRedo(); }
    void undo();
    void redo();
    void goToStep(std::size_t to);

    JobRunner& jobs() { return jobs_; }

Q_SIGNALS:
    /// Another project is open.
    void opened();
    /// Project, history or saved state changed.
    void changed();
    /// A step of the history was undone or redone; `before`: the project until then.
    void stepped(const kumite::Project& before);
    /// The derived values changed.
    void analysisChanged();
    void failed(const QString& sentence);

private:
    void step(const std::function<void()>& move);
    bool commit(const std::function<MaybeEdit()>& edit);
    void refresh();
    void analyseNow();
    void takeOver(Analysis analysis);
    void runWaiting();
    void dropWaiting();

    History history_;
    Analysis analysis_;
    QString path_;
    std::string onDisk_;
    bool open_ = false;
    bool unsaved_ = false;
    bool current_ = true;
    std::vector<std::function<void()>> waiting_;  ///< for `current_`, in the order asked
    QString gesture_;              ///< which live edit made the current step; empty: none
    std::size_t gestureStep_ = 0;  ///< the step that it made
    JobRunner jobs_;
};

}  // namespace kumite::studio
