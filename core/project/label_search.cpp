#include "core/project/label_search.h"

#include <algorithm>

namespace kumite {
namespace {

const FighterLabels* proposalsOf(std::span<const FighterLabels> proposals, FighterAddress fighter,
                                 std::size_t actions) {
    const auto found =
        std::find_if(proposals.begin(), proposals.end(),
                     [&](const FighterLabels& each) { return each.fighter == fighter; });
    return found == proposals.end() || found->labels.size() != actions ? nullptr : &*found;
}

}  // namespace

FilterWords filterWords(const Project& project) {
    FilterWords words{*project.labelling.vocabulary, {}};
    for (const Take& take : project.takes)
        words.takes.push_back(take.name);
    return words;
}

Label FoundAction::label() const {
    return ActionLabel{0, values}.label();
}

std::vector<FoundAction> findActions(const Project& project, const Analysis& analysis,
                                     const LabelFilter& filter,
                                     std::span<const FighterLabels> proposals) {
    std::vector<FoundAction> found;
    const int aspects = project.labelling.vocabulary->size();
    for (int t = 0; t < static_cast<int>(project.takes.size()); ++t) {
        const auto& fighters = project.takes[static_cast<std::size_t>(t)].fighters;
        for (int p = 0; p < static_cast<int>(fighters.size()); ++p) {
            const FighterAddress address{t, p};
            const Fighter& fighter = fighters[static_cast<std::size_t>(p)];
            const FighterAnalysis& values = analysis.at(address);
            const auto labels = actionLabels(fighter, values, aspects);
            const FighterLabels* proposed = proposalsOf(proposals, address, labels.size());
            for (std::size_t i = 0; i < labels.size(); ++i) {
                const Action& action = values.segmentation->actions[i];
                FoundAction each{address,
                                 static_cast<int>(i),
                                 timeOfFrame(fighter, action.begin),
                                 timeOfFrame(fighter, action.end),
                                 labels[i].aspects,
                                 {}};
                for (std::size_t a = 0; proposed && a < each.values.size(); ++a) {
                    const AspectValue& value = proposed->labels[i].aspects[a];
                    if (!each.values[a].byHand() && value.known()) each.values[a] = value;
                }
                auto match =
                    filter.match({t, p, each.begin, each.end, each.values, labels[i].anyKnown()});
                if (!match) continue;
                each.match = std::move(*match);
                found.push_back(std::move(each));
            }
        }
    }
    return found;
}

}  // namespace kumite
