#include "core/synthesis/film_strip.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/base/text.h"

namespace kumite {
namespace {

constexpr double kWidth = 150;  ///< of a picture, SVG units
constexpr double kHeight = 165;
constexpr double kScale = 62;  ///< units a metre
constexpr double kTitle = 22;
constexpr const char* kColours[] = {"#c0392b", "#1f5fa8"};

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

Strip shownStrip(BoutTape& tape, int begin, int end, int pictures) {
    Strip strip;
    for (int i = 0; i < pictures; ++i) {
        tape.seek(begin + (end - begin) * i / (pictures - 1));
        strip.frames.push_back(
            {{tape.now().shown(0).joints.positions, tape.now().shown(1).joints.positions}});
    }
    return strip;
}

Strip recordedStrip(const BoutLibrary& library, int player, const LibraryAction& action,
                    int pictures) {
    Strip strip;
    JointFrames joints;
    const LibraryClip& own = library.fighter(player).clipOf(action);
    for (int i = 0; i < pictures; ++i) {
        const int frame = action.begin + action.frames * i / (pictures - 1);
        StripFrame& picture = strip.frames.emplace_back();
        for (const int who : {0, 1}) {
            const LibraryFighter& fighter = library.fighter(who);
            const LibraryClip& clip = (*fighter.clips)[static_cast<std::size_t>(action.clip)];
            if (clip.empty()) continue;
            const int at = who == player ? frame : clip.frameAt(own.secondsAt(frame));
            jointFrames(*fighter.rig, clip.clip.frames[static_cast<std::size_t>(at)], joints);
            picture.joints[static_cast<std::size_t>(who)] = joints.positions;
        }
    }
    return strip;
}

/// The side from which a strip is seen: its horizontal axis in the picture.
Eigen::Vector3d sideways(const Strip& strip) {
    const StripFrame& middle = strip.frames[strip.frames.size() / 2];
    if (middle.joints[0].empty() || middle.joints[1].empty()) return Eigen::Vector3d::UnitX();
    Eigen::Vector3d between = middle.joints[1].front() - middle.joints[0].front();
    between.y() = 0;
    return between.norm() > 1e-6 ? Eigen::Vector3d(between.normalized()) : Eigen::Vector3d::UnitX();
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

void drawFigure(std::string& svg, const Rig& rig, const std::vector<Eigen::Vector3d>& joints,
                const Eigen::Vector3d& centre, const Eigen::Vector3d& across, double x, double y,
                const char* colour) {
    std::string path;
    for (int j = 0; j < rig.jointCount(); ++j) {
        const int parent = rig.joint(j).parent;
        if (parent < 0) continue;
        for (const int end : {parent, j}) {
            const Eigen::Vector3d point = joints[static_cast<std::size_t>(end)];
            path += end == parent ? "M" : "L";
            path += fixed(x + kScale * (point - centre).dot(across), 1) + " " +
                    fixed(y - kScale * point.y(), 1);
        }
    }
    svg += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"3\" "
        "stroke-linecap=\"round\"/>\n",
        path, colour);
}

}  // namespace

std::vector<Strip> filmStrips(const BoutTape& tape, int pictures, int most,
                              const Progress& progress) {
    const BoutLibrary& library = tape.first().library();
    BoutTape looking = tape;
    std::vector<Strip> strips;
    std::set<std::string> seen;
    std::array<std::vector<std::shared_ptr<const BoutChoice>>, 2> byPlayer;
    for (const auto& choice : tape.choices())
        byPlayer[static_cast<std::size_t>(choice->player)].push_back(choice);
    for (const auto& choice : tape.choices()) {
        progress.update(static_cast<double>(strips.size()) / (2 * most));
        if (static_cast<int>(strips.size()) >= 2 * most) break;
        if (choice->node < 0) continue;
        const GraphNode& node = library.graph->node(choice->player, choice->node);
        if (!isTechnique(library.vocabulary(), node.label)) continue;
        const auto& own = byPlayer[static_cast<std::size_t>(choice->player)];
        const auto next = std::find(own.begin(), own.end(), choice) + 1;
        if (next == own.end() || !seen.insert(node.text).second) continue;
        Strip shown = shownStrip(looking, choice->frame, (*next)->frame, pictures);
        shown.title = fmt::format("player {}: {}, frames {} to {}", choice->player + 1, node.text,
                                  choice->frame, (*next)->frame);
        const LibraryAction& action = library.fighter(choice->player).action(choice->action);
        Strip recorded = recordedStrip(library, choice->player, action, pictures);
        const BasicAction& basic = library.graph->action(choice->player, choice->action);
        recorded.title = fmt::format("recorded: take {}, frames {} to {}",
                                     library.graph->takes[static_cast<std::size_t>(basic.take)],
                                     basic.frames.begin, basic.frames.end);
        strips.push_back(std::move(shown));
        strips.push_back(std::move(recorded));
    }
    return strips;
}

std::string filmStripSvg(const BoutLibrary& library, const std::vector<Strip>& strips) {
    std::size_t pictures = 1;
    for (const Strip& strip : strips)
        pictures = std::max(pictures, strip.frames.size());
    const double width = kWidth * static_cast<double>(pictures);
    const double row = kHeight + kTitle;
    const double height = row * static_cast<double>(std::max<std::size_t>(1, strips.size()));
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
        fixed(width, 0), fixed(height, 0));
    for (std::size_t r = 0; r < strips.size(); ++r) {
        const Strip& strip = strips[r];
        const double top = row * static_cast<double>(r);
        svg += fmt::format(
            "<text x=\"6\" y=\"{}\" font-family=\"sans-serif\" font-size=\"13\" "
            "fill=\"#333333\">{}</text>\n",
            fixed(top + 15, 0), escaped(strip.title));
        if (strip.frames.empty()) continue;
        const Eigen::Vector3d across = sideways(strip);
        for (std::size_t i = 0; i < strip.frames.size(); ++i) {
            const StripFrame& picture = strip.frames[i];
            Eigen::Vector3d centre = Eigen::Vector3d::Zero();
            int there = 0;
            for (const auto& joints : picture.joints) {
                if (joints.empty()) continue;
                centre += joints.front();
                ++there;
            }
            if (there > 0) centre /= there;
            const double x = kWidth * (static_cast<double>(i) + 0.5);
            const double floor = top + row - 8;
            svg +=
                fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#bbbbbb\"/>\n",
                            fixed(x - 0.47 * kWidth, 1), fixed(floor, 1),
                            fixed(x + 0.47 * kWidth, 1), fixed(floor, 1));
            for (const std::size_t p : {1, 0}) {
                if (picture.joints[p].empty()) continue;
                drawFigure(svg, *library.fighters[p].rig, picture.joints[p], centre, across, x,
                           floor, kColours[p]);
            }
        }
    }
    return svg + "</svg>\n";
}

}  // namespace kumite
