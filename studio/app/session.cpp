#include "studio/app/session.h"

#include <algorithm>
#include <cmath>

#include "core/project/notes.h"
#include "core/segmentation/corrections.h"
#include "studio/app/words.h"

namespace kumite::studio {

namespace {
/// The shortest stretch that the timeline shows, seconds.
constexpr double kShortestVisible = 0.1;
}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
    connect(&document_, &Document::opened, this, &Session::opened);
    connect(&document_, &Document::analysisChanged, this, [this] {
        followTake();
        refreshMarks();
    });
    connect(&document_, &Document::changed, this, &Session::followTake);
}

void Session::followTake() {
    const auto& takes = document_.project().takes;
    const auto count = static_cast<int>(takes.size());
    const auto nameAt = [&](int take) {
        return take < count ? takes[static_cast<std::size_t>(take)].name : std::string();
    };
    const std::string here = nameAt(take_);
    if (here == takeName_) {
        knownTakes_ = count;
        if (count > 0) stretchSpan();
        return;
    }
    const auto found = std::find_if(takes.begin(), takes.end(),
                                    [&](const Take& take) { return take.name == takeName_; });
    if (found != takes.end()) {
        take_ = static_cast<int>(found - takes.begin());
        refreshMarks();
    } else if (take_ < count && count == knownTakes_) {
        takeName_ = here;  // it was renamed
    } else {
        setTake(std::min(take_, count - 1));  // it was removed
    }
    knownTakes_ = count;
}

void Session::stretchSpan() {
    // A fighter that starts at another time makes the take longer or shorter.
    const TimeSpan before = transport_.span();
    const bool all = visible_.begin <= before.begin && visible_.end >= before.end;
    const TimeSpan now = timeSpan(document_.project().takes[static_cast<std::size_t>(take_)]);
    if (now.begin == before.begin && now.end == before.end) return;
    transport_.stretchSpan(now);
    setVisible(all ? now : visible_);
}

void Session::opened() {
    take_ = 0;
    activePlayer_ = 0;
    selection_.reset();
    selectedAction_.reset();
    refreshMarks();
    setTake(0);
}

void Session::setTake(int take) {
    const auto& takes = document_.project().takes;
    take_ = std::clamp(take, 0, std::max(0, static_cast<int>(takes.size()) - 1));
    takeName_ = takes.empty() ? std::string() : takes[static_cast<std::size_t>(take_)].name;
    knownTakes_ = static_cast<int>(takes.size());
    activePlayer_ = 0;
    selection_.reset();
    selectedAction_.reset();
    refreshMarks();
    transport_.setSpan(takes.empty() ? TimeSpan{}
                                     : timeSpan(takes[static_cast<std::size_t>(take_)]));
    Q_EMIT takeChanged();
    Q_EMIT activePlayerChanged();
    Q_EMIT selectionChanged();
    showAll();
}

int Session::playerCount() const {
    const auto& takes = document_.project().takes;
    if (take_ >= static_cast<int>(takes.size())) return 0;
    return static_cast<int>(takes[static_cast<std::size_t>(take_)].fighters.size());
}

const FighterAnalysis* Session::fighter(int player) const {
    const auto& takes = document_.analysis().takes;
    if (take_ >= static_cast<int>(takes.size())) return nullptr;
    const auto& fighters = takes[static_cast<std::size_t>(take_)];
    if (player < 0 || player >= static_cast<int>(fighters.size())) return nullptr;
    const FighterAnalysis& found = fighters[static_cast<std::size_t>(player)];
    if (!found.available() || player >= playerCount()) return nullptr;
    // Until a job has caught up with the project, another fighter may have stood here.
    const Take& shown = document_.project().takes[static_cast<std::size_t>(take_)];
    const bool same = shown.fighters[static_cast<std::size_t>(player)].motion == found.input.motion;
    return same ? &found : nullptr;
}

const std::vector<BoundaryMark>& Session::marks(int player) const {
    static const std::vector<BoundaryMark> none;
    const auto index = static_cast<std::size_t>(player);
    return player >= 0 && index < marks_.size() ? marks_[index] : none;
}

int Session::shownFrame(int player) const {
    const FighterAnalysis* found = fighter(player);
    return found ? frameAtTime(found->input, transport_.shownTime()) : 0;
}

double Session::timeOf(const BoundaryRef& boundary) const {
    const FighterAnalysis* found = fighter(boundary.player);
    return found ? timeOfFrame(found->input, boundary.frame) : 0.0;
}

void Session::setActivePlayer(int player) {
    if (player == activePlayer_ || player < 0 || player >= playerCount()) return;
    activePlayer_ = player;
    Q_EMIT activePlayerChanged();
}

void Session::select(std::optional<BoundaryRef> boundary) {
    if (boundary == selection_ && !(boundary && selectedAction_)) return;
    selection_ = boundary;
    if (boundary) selectedAction_.reset();
    Q_EMIT selectionChanged();
}

void Session::selectAction(std::optional<ActionRef> action) {
    if (action == selectedAction_ && !(action && selection_)) return;
    selectedAction_ = action;
    if (action) selection_.reset();
    Q_EMIT selectionChanged();
}

const Action* Session::actionOf(const ActionRef& action) const {
    const FighterAnalysis* found = fighter(action.player);
    return found ? kumite::actionAt(*found->segmentation, action.peak) : nullptr;
}

int Session::numberOf(const ActionRef& action) const {
    const Action* found = actionOf(action);
    if (found == nullptr) return -1;
    return static_cast<int>(found - fighter(action.player)->segmentation->actions.data());
}

std::optional<ActionRef> Session::actionAt(int player, int frame) const {
    const Action* action = actionOf({player, frame});
    return action ? std::optional(ActionRef{player, action->peak}) : std::nullopt;
}

std::optional<ActionRef> Session::currentAction() const {
    if (selectedAction_) return selectedAction_;
    return actionAt(activePlayer_, shownFrame(activePlayer_));
}

TimeSpan Session::spanOf(const ActionRef& action) const {
    const Action* found = actionOf(action);
    if (found == nullptr) return transport_.span();
    return {timeOf({action.player, found->begin}), timeOf({action.player, found->end})};
}

QString Session::noteOf(const ActionRef& action) const {
    const Action* found = actionOf(action);
    if (found == nullptr) return {};
    const FighterAnalysis& owner = *fighter(action.player);
    return QString::fromStdString(kumite::noteOf(owner.input.notes, *owner.segmentation, *found));
}

void Session::loopAction(const ActionRef& action) {
    const TimeSpan span = spanOf(action);
    setActivePlayer(action.player);
    selectAction(action);
    transport_.setLoop(span.begin, span.end);
    transport_.setLooping(true);
    transport_.setPlayhead(span.begin);
    frameSelection();
}

void Session::frameSelection() {
    if (selectedAction_) {
        const TimeSpan span = spanOf(*selectedAction_);
        const double air = 0.5 * (span.end - span.begin);
        setVisible({span.begin - air, span.end + air});
    } else if (selection_) {
        constexpr double kAround = 1.5;  // seconds: some actions on both sides
        const double seconds = timeOf(*selection_);
        setVisible({seconds - kAround, seconds + kAround});
    }
}

void Session::setComparison(std::optional<Comparison> comparison) {
    comparison_ = std::move(comparison);
    Q_EMIT comparisonChanged();
}

void Session::goTo(const BoundaryRef& boundary) {
    setActivePlayer(boundary.player);
    select(boundary);
    transport_.setPlayhead(timeOf(boundary));
    reveal(transport_.playhead());
}

void Session::examine(const BoundaryRef& boundary) {
    goTo(boundary);
    constexpr double kNear = 8;  // seconds; who is nearer already stays so
    const double length = std::min(kNear, visible_.end - visible_.begin);
    const double middle = transport_.playhead();
    setVisible({middle - length / 2, middle + length / 2});
    // What plays shows how one action becomes the next.
    constexpr double kAround = 0.8;  // seconds
    transport_.setLoop(std::max(transport_.span().begin, middle - kAround),
                       std::min(transport_.span().end, middle + kAround));
    transport_.setLooping(true);
    Q_EMIT examined();
}

void Session::setVisible(TimeSpan span) {
    const TimeSpan all = transport_.span();
    const double whole = std::max(kShortestVisible, all.end - all.begin);
    const double length = std::clamp(span.end - span.begin, kShortestVisible, whole);
    const double middle = 0.5 * (span.begin + span.end);
    visible_.begin = std::clamp(middle - length / 2, all.begin, all.begin + whole - length);
    visible_.end = visible_.begin + length;
    Q_EMIT visibleChanged();
}

void Session::showAll() {
    setVisible(transport_.span());
}

void Session::reveal(double seconds) {
    const double length = visible_.end - visible_.begin;
    if (seconds < visible_.begin) {
        setVisible({seconds - 0.1 * length, seconds + 0.9 * length});
    } else if (seconds > visible_.end) {
        setVisible({seconds - 0.9 * length, seconds + 0.1 * length});
    }
}

void Session::refreshMarks() {
    marks_.clear();
    for (int player = 0; player < playerCount(); ++player) {
        const FighterAnalysis* found = fighter(player);
        marks_.push_back(found ? boundaryMarks(*found) : std::vector<BoundaryMark>{});
    }
    keepSelection();
    Q_EMIT fightersChanged();
    const bool known = take_ < static_cast<int>(document_.analysis().takes.size());
    if (awaited_ && known) Q_EMIT takeChanged();
    awaited_ = !known;
}

void Session::keepSelection() {
    if (selectedAction_) {
        const Action* action = actionOf(*selectedAction_);
        selectAction(action ? std::optional(ActionRef{selectedAction_->player, action->peak})
                            : std::nullopt);
    }
    if (!selection_) return;
    const FighterAnalysis* found = fighter(selection_->player);
    const double reach = found ? kCorrectionReach * found->input.rate : 0.0;
    const BoundaryMark* mark = nearestMark(marks(selection_->player), selection_->frame, reach);
    select(mark ? std::optional(BoundaryRef{selection_->player, mark->frame}) : std::nullopt);
}

void Session::stepFrames(int count) {
    const FighterAnalysis* found = fighter(activePlayer_);
    if (found == nullptr) return;
    const int frame = frameAtTime(found->input, transport_.playhead()) + count;
    transport_.setPlayhead(
        timeOfFrame(found->input, std::clamp(frame, 0, found->frameCount() - 1)));
    reveal(transport_.playhead());
}

void Session::stepBoundary(int direction) {
    const FighterAnalysis* found = fighter(activePlayer_);
    if (found == nullptr) return;
    const int now = frameAtTime(found->input, transport_.playhead());
    const BoundaryMark* next = nullptr;
    for (const BoundaryMark& mark : marks(activePlayer_)) {
        if (!mark.isLive()) continue;
        if (direction > 0 && mark.frame > now) {
            next = &mark;
            break;
        }
        if (direction < 0 && mark.frame < now) next = &mark;
    }
    if (next == nullptr) return;
    const BoundaryRef boundary{activePlayer_, next->frame};
    if (next->isEditable()) {
        goTo(boundary);
    } else {
        select(std::nullopt);
        transport_.setPlayhead(timeOf(boundary));
        reveal(transport_.playhead());
    }
}

void Session::stepAction(int direction) {
    const auto now = currentAction();
    if (!now || now->player != activePlayer_) return;
    const FighterAnalysis* found = fighter(activePlayer_);
    const auto& actions = found->segmentation->actions;
    const int index = numberOf(*now);
    // The first step selects the action at the playhead.
    const int next = selectedAction_ ? index + direction : index;
    if (next < 0 || next >= static_cast<int>(actions.size())) return;
    const Action& action = actions[static_cast<std::size_t>(next)];
    selectAction(ActionRef{activePlayer_, action.peak});
    transport_.setPlayhead(timeOfFrame(found->input, action.begin));
    reveal(timeOfFrame(found->input, action.end));
    reveal(transport_.playhead());
}

}  // namespace kumite::studio
