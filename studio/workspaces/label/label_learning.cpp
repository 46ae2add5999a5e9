#include "studio/workspaces/label/label_learning.h"

#include <chrono>

namespace kumite::studio {

namespace {

/// How long a hand must rest before the thorough round starts.
constexpr std::chrono::milliseconds kRest(350);
/// Parameters are searched anew when there are so many times as many examples.
constexpr double kSearchAgain = 1.33;

}  // namespace

LabelLearning::LabelLearning(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    rest_.setSingleShot(true);
    rest_.setInterval(kRest);
    connect(&rest_, &QTimer::timeout, this, &LabelLearning::startThoroughRound);
    for (JobRunner* runner : {&groundJobs_, &roundJobs_, &thoroughJobs_}) {
        connect(runner, &JobRunner::failed, this, &LabelLearning::failed);
        connect(runner, &JobRunner::started, this, &LabelLearning::busyChanged);
    }
}

void LabelLearning::setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    follow();
}

void LabelLearning::reset() {
    for (JobRunner* runner : {&groundJobs_, &roundJobs_, &thoroughJobs_})
        runner->cancel();
    rest_.stop();
    key_ = {};
    ground_.reset();
    learnt_.reset();
    examples_.clear();
    parameters_.clear();
    searchedAt_ = 0;
    roundDue_ = thoroughDue_ = false;
}

void LabelLearning::setQuerySettings(const QuerySettings& settings) {
    query_ = settings;
    key_ = {};
    follow();
}

LabelLearning::GroundKey LabelLearning::keyNow() const {
    GroundKey key;
    for (const auto& take : document_.analysis().takes) {
        for (const FighterAnalysis& fighter : take) {
            key.parts.push_back(fighter.segmentation);
            key.parts.push_back(fighter.motion);
            key.parts.push_back(fighter.body);
        }
        key.parts.push_back(nullptr);  // ends the take
    }
    return key;
}

bool LabelLearning::sameSettings(const Project& project) const {
    const LabelSettings& now = project.labelling;
    return now.vocabulary == settings_.vocabulary && now.rules == settings_.rules &&
           now.learning == settings_.learning;
}

bool LabelLearning::isCurrent(bool thoroughly) const {
    return learnt_ && learnt_->ground == ground_ && !roundDue_ && !roundJobs_.isRunning() &&
           !groundJobs_.isRunning() && (!thoroughly || (learnt_->calibrated && !thoroughDue_));
}

bool LabelLearning::isBusy() const {
    return groundJobs_.isRunning() || roundJobs_.isRunning() || thoroughJobs_.isRunning() ||
           rest_.isActive();
}

LearningInput LabelLearning::inputNow() const {
    return {document_.project(), document_.analysis(), ground_, examples_, parameters_};
}

void LabelLearning::follow() {
    if (!active_ || !document_.isOpen() || !document_.isCurrent()) return;
    const GroundKey key = keyNow();
    if (!(key == key_)) {
        key_ = key;
        makeGround();
        return;
    }
    if (!ground_ || groundJobs_.isRunning()) return;
    const Project& project = document_.project();
    std::vector<Example> examples = handExamples(project, document_.analysis(), ground_->table);
    const bool other = !sameSettings(project);
    const bool newGround = !learnt_ || learnt_->ground != ground_;
    if (!other && !newGround && examples == examples_) return;
    if (other || parameters_.empty()) {
        parameters_ = project.labelling.model ? project.labelling.model->parameters
                                              : defaultParameters(*project.labelling.vocabulary);
        searchedAt_ = project.labelling.model ? examples.size() : 0;
    }
    settings_ = project.labelling;
    examples_ = std::move(examples);
    roundDue_ = true;
    startRound();
}

void LabelLearning::makeGround() {
    roundJobs_.cancel();
    thoroughJobs_.cancel();
    rest_.stop();
    groundJobs_.start(
        tr("Comparing actions"),
        [project = document_.project(), analysis = document_.analysis(),
         query = query_](const Progress& progress) {
            ActionTable table = actionTable(project, analysis, progress);
            return std::make_shared<LearningGround>(std::move(table), analysis, query);
        },
        [this](std::shared_ptr<LearningGround> ground) {
            ground_ = std::move(ground);
            follow();
            Q_EMIT busyChanged();
        });
}

void LabelLearning::startRound() {
    if (!roundDue_ || roundJobs_.isRunning()) return;
    roundDue_ = false;
    thoroughDue_ = true;
    roundJobs_.start(
        tr("Learning"),
        [input = inputNow(), before = learnt_](const Progress& progress) {
            return learnMargins(input, before.get(), progress);
        },
        [this](LearntLabels labels) {
            take(std::move(labels));
            startRound();
            if (!roundJobs_.isRunning()) rest_.start();
        });
}

void LabelLearning::startThoroughRound() {
    // One that is under way is not wasted: its probabilities are taken over, then comes the next.
    if (!thoroughDue_ || thoroughJobs_.isRunning()) return;
    thoroughDue_ = false;
    const auto count = static_cast<double>(examples_.size());
    const bool search = count >= kSearchAgain * static_cast<double>(searchedAt_);
    thoroughJobs_.start(
        tr("Calibrating"),
        [input = inputNow(), search](const Progress& progress) {
            return learnThoroughly(input, search, progress);
        },
        [this, search](LearntLabels labels) {
            if (search) {
                parameters_ = labels.parameters;
                searchedAt_ = labels.examples.size();
            }
            take(std::move(labels));
            if (thoroughDue_ && !roundJobs_.isRunning()) rest_.start();
            Q_EMIT busyChanged();
        });
}

void LabelLearning::take(LearntLabels labels) {
    if (labels.ground != ground_) return;
    if (labels.calibrated && labels.examples != examples_) {
        // Late: the margins of the newest round stand; of this one only what agrees is new.
        if (!learnt_ || learnt_->ground != ground_) return;
        auto mended = std::make_shared<LearntLabels>(*learnt_);
        takeOverConfidences(mended->predictions, labels.predictions);
        learnt_ = std::move(mended);
    } else {
        if (labels.calibrated && learnt_) labels.batch = learnt_->batch;
        learnt_ = std::make_shared<const LearntLabels>(std::move(labels));
    }
    Q_EMIT updated();
}

}  // namespace kumite::studio
