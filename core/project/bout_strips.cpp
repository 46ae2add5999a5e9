#include "core/project/bout_strips.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

namespace kumite {
namespace {

constexpr const char* kColours[] = {"#c0503a", "#4878b0"};  ///< of players 1 and 2

/// The aspects of a label that are not at their fallback, with their qualifiers.
std::vector<std::pair<std::size_t, int>> techniquesOf(const Vocabulary& vocabulary,
                                                      const Label& label) {
    std::vector<std::pair<std::size_t, int>> techniques;
    for (std::size_t a = 0; a < label.size(); ++a) {
        const Aspect& aspect = vocabulary.aspects[a];
        if (aspect.classifier != Classifier::MoveRule && label[a] != kUnknown &&
            aspect.fallback != label[a])
            techniques.emplace_back(a, label[a]);
    }
    return techniques;
}

/// What both players chose and showed to its end, in order of time.
std::vector<ShownAction> finished(const BoutTape& tape) {
    std::vector<ShownAction> list;
    for (const int player : {0, 1}) {
        auto shown = actionsShown(tape, player);
        shown.pop_back();
        std::copy_if(shown.begin(), shown.end(), std::back_inserter(list),
                     [](const ShownAction& each) { return each.choice && each.node != kAnyNode; });
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const ShownAction& a, const ShownAction& b) { return a.begin < b.begin; });
    return list;
}

/// The first actions that show a technique, then those with other labels; in order of time.
std::vector<ShownAction> firstOfEach(const BoutTape& tape, int most) {
    const BoutLibrary& library = tape.first().library();
    std::vector<ShownAction> fresh, others;
    std::set<std::pair<std::size_t, int>> known;
    std::set<std::string> labels;
    for (const ShownAction& shown : finished(tape)) {
        const GraphNode& node = library.graph->node(shown.choice->player, shown.node);
        const auto techniques = techniquesOf(library.vocabulary(), node.label);
        if (techniques.empty() || !labels.insert(node.text).second) continue;
        const std::size_t before = known.size();
        known.insert(techniques.begin(), techniques.end());
        (known.size() > before ? fresh : others).push_back(shown);
    }
    const auto room = static_cast<std::size_t>(std::max(0, most));
    fresh.resize(std::min(fresh.size(), room));
    others.resize(std::min(others.size(), room - fresh.size()));
    fresh.insert(fresh.end(), others.begin(), others.end());
    std::stable_sort(fresh.begin(), fresh.end(),
                     [](const ShownAction& a, const ShownAction& b) { return a.begin < b.begin; });
    return fresh;
}

}  // namespace

std::string boutStripsSvg(const BoutTape& tape, const BoutStripSettings& settings,
                          const Progress& progress) {
    const BoutLibrary& library = tape.first().library();
    const std::array<Clip, 2> clips = boutClips(tape, progress.part(0, 0.8));
    std::vector<FilmRow> rows;
    for (const ShownAction& shown : firstOfEach(tape, settings.most)) {
        const BoutChoice& choice = *shown.choice;
        const int player = choice.player;
        const BoutAction& action = library.fighter(player).action(choice.action);
        const BasicAction& basic = library.graph->action(player, choice.action);
        const LibraryClip& own = library.fighter(player).clipOf(action);
        FilmRow bout, recorded;
        bout.title =
            fmt::format("player {}: {}, frames {} to {}", player + 1,
                        library.graph->node(player, choice.node).text, choice.frame, shown.end);
        recorded.title = fmt::format("recorded: take {}, frames {} to {}",
                                     library.graph->takes[static_cast<std::size_t>(basic.take)],
                                     basic.frames.begin, basic.frames.end);
        for (int i = 0; i < settings.pictures; ++i) {
            const double share = settings.pictures > 1 ? double(i) / (settings.pictures - 1) : 0.0;
            const int frame =
                choice.frame + static_cast<int>(std::lround(share * (shown.end - choice.frame)));
            const int source = action.begin + static_cast<int>(std::lround(share * action.frames));
            FilmPicture& now = bout.pictures.emplace_back();
            FilmPicture& then = recorded.pictures.emplace_back();
            now.caption = std::to_string(frame);
            for (const std::size_t p : {0, 1}) {
                now.figures.push_back({&clips[p], frame, kColours[p], 1});
                const LibraryClip& clip =
                    (*library.fighters[p].clips)[static_cast<std::size_t>(action.clip)];
                if (clip.empty()) continue;
                const int at =
                    static_cast<int>(p) == player ? source : clip.frameAt(own.secondsAt(source));
                then.figures.push_back({&clip.clip, at, kColours[p], 1});
            }
        }
        rows.push_back(std::move(bout));
        rows.push_back(std::move(recorded));
    }
    FilmSettings film;
    film.view = settings.view;
    std::string svg =
        filmStripSvg("Synthesised actions and the recorded ones they were made from", rows, film);
    progress.update(1);
    return svg;
}

}  // namespace kumite
