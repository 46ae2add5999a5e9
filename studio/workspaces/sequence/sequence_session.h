#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/project/library.h"
#include "core/project/sequence_draft.h"
#include "core/transition/playback.h"
#include "studio/app/session.h"
#include "studio/workspaces/made_motion.h"

namespace kumite::studio {

/// What sequences are made of: the project's takes and clips, and the graph over their poses.
struct SequenceSource {
    Project made;  ///< what it was made of, without drafts
    std::shared_ptr<const MotionLibrary> library;
    std::shared_ptr<const FlexibleGraph> graph;
    std::vector<Eigen::Vector2d> places;  ///< of the clusters, for a map
    Findings findings;
    QString whyNothing;  ///< what is missing; else empty
};

/// A block of the sequence, or the transition that leads to it.
struct SequencePart {
    int block = 0;
    bool transition = false;

    bool operator==(const SequencePart&) const = default;
};

/// What the Sequence workspace works on. The plan is the project's draft: every change of it is a
/// step of the history. Library, graph and motion are computed beside the window; the latest wins.
class SequenceSession : public QObject {
    Q_OBJECT

public:
    explicit SequenceSession(Session& session, QObject* parent = nullptr);

    Session& session() { return session_; }
    JobRunner& jobs() { return jobs_; }
    JobRunner& making() { return making_; }
    JobRunner& writing() { return writing_; }
    /// Prepares and makes only while somebody looks.
    void setActive(bool active);
    bool isActive() const { return active_; }
    bool isPreparing() const { return jobs_.isRunning() || due_.isActive(); }

    /// Null until it was prepared for the first time, or where there is nothing to make it of.
    const MotionLibrary* library() const;
    std::shared_ptr<const MotionLibrary> sharedLibrary() const;
    /// Null where there is no library.
    std::shared_ptr<const FlexibleGraph> graph() const {
        return source_ ? source_->graph : nullptr;
    }
    const std::vector<Eigen::Vector2d>& places() const { return source_->places; }
    const Findings& findings() const;
    /// Of the project that the library was made of.
    int takeCount() const { return source_ ? static_cast<int>(source_->made.takes.size()) : 0; }
    QString whyNothing() const;
    /// An action or block as people read it: its label, else its name.
    QString titleOf(const LibraryAction& action) const;
    QString titleOf(const DraftBlock& block) const;

    const SequenceDraft& draft() const { return draft_; }
    /// The motion that was made last; null where there is none.
    const SequenceMotion* motion() const { return motion_.get(); }
    /// The same to be kept or written; there must be one.
    MadeMotion madeMotion() const;
    /// Whether the motion is that of the draft as it is now.
    bool isCurrent() const { return motion_ != nullptr && shownDraft_ == draft_; }
    /// Why the draft gives no motion; else empty.
    QString problem() const { return problem_; }

    // Edits; one step of the history each.
    void insert(const LibraryAction& action, std::optional<int> at = {});
    void replace(int block, const LibraryAction& action);
    void remove(int block);
    void move(int block, int to);
    void clear();
    /// Changes one block. `edit` is what the history shows.
    void change(int block, const QString& edit, const std::function<void(DraftBlock&)>& act);
    /// Other draws for a transition, or for all that are not locked.
    void drawAnew(std::optional<int> block);

    const std::optional<SequencePart>& selected() const { return selected_; }
    void select(std::optional<SequencePart> part);
    /// The selected block, or the one that the selected transition leads to.
    std::optional<int> selectedBlock() const;
    /// The piece of the motion that the selection is; null where the motion has none.
    const SequencePiece* selectedPiece() const;

    // What is shown in the 3D view: the sequence, an action of the browser, or what keys drive.
    enum class Showing { Sequence, Action, Live };
    Showing showing() const { return showing_; }
    /// Whether the map of poses stands beside the 3D view.
    bool showsMap() const { return map_; }
    void setMap(bool on) {
        map_ = on;
        Q_EMIT mapToggled();
        Q_EMIT stateChanged();
    }
    /// Plays an action in a loop; nothing: back to the sequence.
    void preview(const std::optional<LibraryAction>& action);
    /// Keys play actions at once.
    void setLive(bool live);
    void playLive(int block);
    const std::optional<TransitionReport>& liveReport() const { return liveReport_; }

    /// The shown pose; null where nothing is shown.
    const Pose* pose() const { return shown_ ? &*shown_ : nullptr; }
    double seconds() const { return seconds_; }
    double length() const;  ///< of what is shown, seconds
    void seek(double seconds);
    void step(int frames);
    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);
    /// From the end to the start again.
    bool isLooping() const { return looping_; }
    void setLooping(bool on) {
        looping_ = on;
        Q_EMIT stateChanged();
    }

Q_SIGNALS:
    /// Another library, or none.
    void libraryChanged();
    void draftChanged();
    void motionChanged();
    void selectionChanged();
    /// Another moment or pose is shown.
    void moved();
    /// Plays, prepares, shows something else: what commands and buttons depend on.
    void stateChanged();
    void mapToggled();
    void failed(const QString& sentence);

private:
    void follow();
    void prepare();
    void make();
    void apply(SequenceDraft draft, const QString& edit);
    void advance();
    void show();
    const Clip* clip() const;

    Session& session_;
    JobRunner jobs_, making_, writing_;
    QTimer due_, timer_;
    QElapsedTimer clock_;
    bool active_ = false;
    bool map_ = false;
    bool looping_ = false;
    std::shared_ptr<const SequenceSource> source_;
    SequenceDraft draft_, shownDraft_;
    std::shared_ptr<const SequenceMotion> motion_;
    QString problem_;
    std::optional<SequencePart> selected_;
    Showing showing_ = Showing::Sequence;
    Clip preview_;
    std::unique_ptr<PlaybackBuffer> live_;
    std::optional<TransitionReport> liveReport_;
    double owed_ = 0;  ///< live frames
    double seconds_ = 0;
    std::optional<Pose> shown_;
};

}  // namespace kumite::studio
