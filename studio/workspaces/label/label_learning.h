#pragma once

#include <QObject>
#include <QTimer>

#include <memory>

#include "studio/app/document.h"
#include "studio/jobs/job_runner.h"
#include "studio/workspaces/label/learnt_labels.h"

namespace kumite::studio {

/// Learns beside the window whatever hands have labelled: margins at once after every label,
/// calibrated probabilities and the expected accuracy when the hand rests. At most one round of
/// each runs at a time; one that ends too late for the newest label is followed by another. What
/// belongs to boundaries that have changed is dropped. Belongs to the GUI thread.
class LabelLearning : public QObject {
    Q_OBJECT

public:
    explicit LabelLearning(const Document& document, QObject* parent = nullptr);

    /// Whether anybody looks. While nobody does, nothing is computed.
    void setActive(bool active);
    bool isActive() const { return active_; }
    /// Another document: nothing that was learnt holds.
    void reset();
    /// Looks at the document and starts what has become necessary.
    void follow();

    /// What was found last; null before the first round. It may belong to earlier labels, or to
    /// boundaries from before the last edit.
    const std::shared_ptr<const LearntLabels>& learnt() const { return learnt_; }
    /// The newest labels have been learnt; with `thoroughly` also calibrated.
    bool isCurrent(bool thoroughly = false) const;
    /// Something is being computed or about to be.
    bool isBusy() const;

    const QuerySettings& querySettings() const { return query_; }
    void setQuerySettings(const QuerySettings& settings);

Q_SIGNALS:
    /// `learnt` is new.
    void updated();
    /// Became busy or idle.
    void busyChanged();
    void failed(const QString& sentence);

private:
    /// By what a ground is known: unchanged pointers mean unchanged values.
    struct GroundKey {
        std::vector<std::shared_ptr<const void>> parts;
        bool operator==(const GroundKey&) const = default;
    };
    GroundKey keyNow() const;
    bool sameSettings(const Project& project) const;
    LearningInput inputNow() const;
    void makeGround();
    void startRound();
    void startThoroughRound();
    void take(LearntLabels labels);

    const Document& document_;
    bool active_ = false;
    QuerySettings query_;
    GroundKey key_;
    std::shared_ptr<LearningGround> ground_;
    std::vector<Example> examples_;  ///< of the document as it is now
    LabelSettings settings_;         ///< by which it is learnt
    ParameterSet parameters_;
    std::size_t searchedAt_ = 0;  ///< examples at the last search for parameters
    std::shared_ptr<const LearntLabels> learnt_;
    bool roundDue_ = false;
    bool thoroughDue_ = false;
    QTimer rest_;  ///< until the hand has rested for a moment
    JobRunner groundJobs_;
    JobRunner roundJobs_;
    JobRunner thoroughJobs_;
};

}  // namespace kumite::studio
