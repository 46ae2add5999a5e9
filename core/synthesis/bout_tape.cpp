#include "core/synthesis/bout_tape.h"

#include <algorithm>
#include <cmath>

namespace kumite {
namespace {

/// A snapshot takes some 30 kB, showing a second anew some milliseconds.
constexpr double kSnapshotSeconds = 4;

/// Applies the commands that are due at the bout's frame, from `next` on.
void obey(Bout& bout, const std::vector<BoutCommand>& commands, std::size_t& next) {
    while (next < commands.size() && commands[next].frame <= bout.frame())
        bout.apply(commands[next++]);
}

int snapshotSpacing(const BoutLibrary& library) {
    return std::max(1, static_cast<int>(std::lround(kSnapshotSeconds * library.rate)));
}

}  // namespace

BoutTape::BoutTape(std::shared_ptr<const BoutLibrary> library, const BoutSettings& settings,
                   std::vector<BoutCommand> script)
    : now_(std::move(library), settings), commands_(std::move(script)) {
    snapshots_.push_back(now_);
    Bout trial = now_;
    for (const BoutCommand& command : commands_)
        trial.apply(command);
}

void BoutTape::stepOnce() {
    obey(now_, commands_, applied_);
    now_.step();
    if (now_.frame() <= end_) return;
    end_ = now_.frame();
    for (auto& choice : now_.newChoices())
        choices_.push_back(std::move(choice));
    if (end_ % snapshotSpacing(now_.library()) == 0) snapshots_.push_back(now_);
}

void BoutTape::advance(int frames) {
    for (int i = 0; i < frames; ++i)
        stepOnce();
}

void BoutTape::seek(int frame) {
    frame = std::clamp(frame, 0, end_);
    const auto nearest = static_cast<std::size_t>(frame / snapshotSpacing(now_.library()));
    if (frame < now_.frame() || snapshots_[nearest].frame() > now_.frame()) {
        now_ = snapshots_[nearest];
        applied_ = static_cast<std::size_t>(
            std::lower_bound(commands_.begin(), commands_.end(), now_.frame(),
                             [](const BoutCommand& each, int at) { return each.frame < at; }) -
            commands_.begin());
    }
    while (now_.frame() < frame)
        stepOnce();
    obey(now_, commands_, applied_);
}

void BoutTape::cut() {
    end_ = now_.frame();
    commands_.resize(applied_);
    while (snapshots_.size() > 1 && snapshots_.back().frame() > end_)
        snapshots_.pop_back();
    std::erase_if(choices_, [&](const auto& choice) { return choice->frame >= end_; });
}

void BoutTape::command(BoutCommand command) {
    command.frame = now_.frame();
    obey(now_, commands_, applied_);
    now_.apply(command);
    cut();
    commands_.push_back(std::move(command));
    applied_ = commands_.size();
}

void BoutTape::chooseInstead(const BoutChoice& choice, int node) {
    BoutCommand wanted;
    wanted.kind = BoutCommand::Kind::Choose;
    wanted.player = choice.player;
    wanted.words = now_.library().graph->node(choice.player, node).text;
    seek(choice.frame);
    command(std::move(wanted));
}

void BoutTape::replay(const std::function<void(const Bout&)>& show,
                      const Progress& progress) const {
    Bout bout = snapshots_.front();
    std::size_t next = 0;
    show(bout);
    while (bout.frame() < end_) {
        obey(bout, commands_, next);
        bout.step();
        show(bout);
        if (bout.frame() % 64 == 0) progress.update(static_cast<double>(bout.frame()) / end_);
    }
    progress.update(1);
}

std::vector<ShownAction> actionsShown(const BoutTape& tape, int player) {
    const FighterShown& first = tape.first().shown(player);
    std::vector<ShownAction> actions = {{0, tape.end(), first.action, first.node, nullptr}};
    for (const auto& choice : tape.choices()) {
        if (choice->player != player) continue;
        actions.back().end = choice->frame;
        // The very first choice may fall on frame 0, where nothing of the action before was shown.
        if (choice->frame == 0) actions.clear();
        actions.push_back({choice->frame, tape.end(), choice->action, choice->node, choice});
    }
    return actions;
}

std::array<Clip, 2> boutClips(const BoutTape& tape, const Progress& progress) {
    std::array<Clip, 2> clips;
    for (const int player : {0, 1}) {
        Clip& clip = clips[static_cast<std::size_t>(player)];
        clip.rig = tape.first().library().fighter(player).rig;
        clip.rate = tape.first().library().rate;
        clip.frames.reserve(static_cast<std::size_t>(tape.end()) + 1);
    }
    tape.replay(
        [&](const Bout& bout) {
            for (const int player : {0, 1})
                clips[static_cast<std::size_t>(player)].frames.push_back(bout.shown(player).pose);
        },
        progress);
    return clips;
}

}  // namespace kumite
