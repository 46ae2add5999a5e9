#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/project/label_files.h"

namespace kumite {
namespace {

double overlapOf(const Span& span, const Action& action, double rate) {
    return std::min(span.end, action.end / rate) - std::max(span.begin, action.begin / rate);
}

/// Brings labels to actions, one after the other.
class Matching {
public:
    Matching(const Project& project, const Analysis& analysis, std::optional<int> take)
        : project_(project), analysis_(analysis), take_(take) {
        if (!take_ && project.takes.size() == 1) take_ = 0;
    }

    void add(const TimedLabel& label) {
        const auto take = takeOf(label);
        if (!take) return refuse(label, "the project has no take \"" + label.take + "\".");
        const FighterAddress address{*take, label.player - 1};
        const auto players = project_.takes[static_cast<std::size_t>(*take)].fighters.size();
        if (address.player >= static_cast<int>(players) || !analysis_.at(address).segmentation) {
            return refuse(label, "the take has no such fighter.");
        }
        const double rate = fighterAt(project_, address).rate;
        const Span span = spanOn(project_, address, label);
        const std::vector<Action>& actions = analysis_.at(address).segmentation->actions;
        const auto best =
            std::max_element(actions.begin(), actions.end(), [&](const Action& a, const Action& b) {
                return overlapOf(span, a, rate) < overlapOf(span, b, rate);
            });
        const double least =
            best == actions.end()
                ? 0
                : 0.5 * std::min(span.end - span.begin, (best->end - best->begin) / rate);
        if (best == actions.end() || overlapOf(span, *best, rate) < least - 1e-6) {
            return refuse(label, "no action there.");
        }
        give(label, address, static_cast<std::size_t>(best - actions.begin()),
             overlapOf(span, *best, rate));
    }

    MatchedLabels result() {
        std::set<const TimedLabel*> matched;
        for (const auto& actions : owners_) {
            for (const std::vector<Owner>& action : actions) {
                for (const Owner& owner : action) {
                    if (owner.label) matched.insert(owner.label);
                }
            }
        }
        result_.matched = static_cast<int>(matched.size());
        return std::move(result_);
    }

private:
    struct Owner {
        const TimedLabel* label = nullptr;
        double overlap = 0;
    };

    std::optional<int> takeOf(const TimedLabel& label) const {
        for (std::size_t t = 0; t < project_.takes.size(); ++t) {
            if (project_.takes[t].name == label.take) return static_cast<int>(t);
        }
        const bool another = !label.take.empty() && project_.takes.size() > 1;
        return another ? std::nullopt : take_;
    }

    void refuse(const TimedLabel& label, const std::string& why) {
        result_.unmatched.push_back(
            warning(fmt::format("{} ({}–{} s, fighter {}): {}", label.place, fixed(label.begin, 2),
                                fixed(label.end, 2), label.player, why)));
    }

    std::size_t indexOf(FighterAddress address) {
        for (std::size_t i = 0; i < result_.fighters.size(); ++i) {
            if (result_.fighters[i].fighter == address) return i;
        }
        // Nothing is known yet: only what the file says is handed on.
        const int aspects = project_.labelling.vocabulary->size();
        std::vector<ActionLabel> open =
            actionLabels(fighterAt(project_, address), analysis_.at(address), aspects);
        for (ActionLabel& label : open)
            label.aspects.assign(static_cast<std::size_t>(aspects), {});
        owners_.emplace_back(open.size(), std::vector<Owner>(static_cast<std::size_t>(aspects)));
        result_.fighters.push_back({address, std::move(open)});
        return result_.fighters.size() - 1;
    }

    /// Every aspect goes to the label that overlaps the action longest.
    void give(const TimedLabel& label, FighterAddress address, std::size_t action, double overlap) {
        const std::size_t fighter = indexOf(address);
        const TimedLabel* stronger = nullptr;
        std::vector<const TimedLabel*> weaker;
        for (std::size_t a = 0; a < label.aspects.size(); ++a) {
            if (!label.aspects[a].known()) continue;
            Owner& owner = owners_[fighter][action][a];
            if (owner.label && owner.overlap >= overlap) {
                stronger = owner.label;
                continue;
            }
            if (owner.label &&
                std::find(weaker.begin(), weaker.end(), owner.label) == weaker.end()) {
                weaker.push_back(owner.label);
            }
            owner = {&label, overlap};
            result_.fighters[fighter].labels[action].aspects[a] = label.aspects[a];
        }
        if (stronger) refuse(label, "its action takes the label of " + stronger->place + ".");
        for (const TimedLabel* each : weaker)
            refuse(*each, "its action takes the label of " + label.place + ".");
    }

    const Project& project_;
    const Analysis& analysis_;
    std::optional<int> take_;
    /// Per fighter of the result, action and aspect.
    std::vector<std::vector<std::vector<Owner>>> owners_;
    MatchedLabels result_;
};

}  // namespace

Span spanOn(const Project& project, FighterAddress fighter, const TimedLabel& label) {
    if (!label.onEafClock) return {label.begin, label.end};
    const Take& take = project.takes[static_cast<std::size_t>(fighter.take)];
    const double shift = eafClockStart(take) - fighterAt(project, fighter).offset;
    return {label.begin + shift, label.end + shift};
}

MatchedLabels matchLabels(const Project& project, const Analysis& analysis,
                          const std::vector<TimedLabel>& labels, std::optional<int> take) {
    Matching matching(project, analysis, take);
    for (const TimedLabel& label : labels)
        matching.add(label);
    return matching.result();
}

}  // namespace kumite
