#include "core/project/bout_strips.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace kumite {
namespace {

constexpr const char* kColours[] = {"#c0503a", "#4878b0"};  ///< of players 1 and 2

/// Whether something happens beside steps.
bool isTechnique(const Vocabulary& vocabulary, const Label& label) {
    for (std::size_t a = 0; a < label.size(); ++a) {
        const Aspect& aspect = vocabulary.aspects[a];
        if (aspect.classifier != Classifier::MoveRule && label[a] != kUnknown &&
            aspect.fallback != label[a])
            return true;
    }
    return false;
}

/// An action of a bout and when it ended.
struct ShownAction {
    std::shared_ptr<const BoutChoice> choice;
    int end = 0;
};

std::vector<ShownAction> firstOfEachLabel(const BoutTape& tape, int most) {
    const BoutLibrary& library = tape.first().library();
    std::vector<ShownAction> list;
    std::set<std::string> seen;
    const auto& choices = tape.choices();
    for (std::size_t i = 0; i < choices.size() && static_cast<int>(list.size()) < most; ++i) {
        const auto& choice = choices[i];
        if (choice->node == kAnyNode) continue;
        const GraphNode& node = library.graph->node(choice->player, choice->node);
        if (!isTechnique(library.vocabulary(), node.label)) continue;
        const auto next =
            std::find_if(choices.begin() + static_cast<std::ptrdiff_t>(i) + 1, choices.end(),
                         [&](const auto& each) { return each->player == choice->player; });
        if (next == choices.end() || !seen.insert(node.text).second) continue;
        list.push_back({choice, (*next)->frame});
    }
    return list;
}

}  // namespace

std::string boutStripsSvg(const BoutTape& tape, const BoutStripSettings& settings,
                          const Progress& progress) {
    const BoutLibrary& library = tape.first().library();
    const std::array<Clip, 2> clips = boutClips(tape, progress.part(0, 0.8));
    std::vector<FilmRow> rows;
    for (const ShownAction& shown : firstOfEachLabel(tape, settings.most)) {
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
