#include "core/cli/sequence_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/project/sequence_draft.h"
#include "core/quality/quality.h"

namespace kumite::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

void addReport(Json& json, const TransitionReport& report) {
    json["method"] = methodName(report.method);
    json["path"] = report.visited;
    json["cost"] = report.cost();
    json["source"] = {{"cluster", report.source.id}, {"distance", report.source.distance}};
    json["target"] = {{"cluster", report.target.id}, {"distance", report.target.distance}};
    Json candidates = Json::array();
    for (const CandidatePath& path : report.candidates)
        candidates.push_back({{"cost", path.cost}, {"nodes", path.nodes}});
    json["candidates"] = std::move(candidates);
    Json joins = Json::array();
    for (const DistanceGrid& grid : report.grids)
        joins.push_back(grid.at(grid.row, grid.column));
    json["join_distances"] = std::move(joins);
}

/// How good the whole motion is, its joins held against what lies between them.
Json qualityOf(const SequenceMotion& motion) {
    JudgedMotion judged;
    judged.fighters.push_back({&motion.clip, 0, motion.joins()});
    return qualityJson(measureQuality(judged));
}

/// A seed per transition, so that one can be drawn anew without touching the others.
std::uint64_t seedOf(std::uint64_t seed, std::size_t block) {
    return seed + 1000003 * static_cast<std::uint64_t>(block);
}

}  // namespace

void addTransitionOptions(CLI::App& command, TransitionOptions& options) {
    command
        .add_option("--method", options.method,
                    "along recorded clips, on a curve, or straight; else clips where there is a "
                    "path, and a curve where there is none")
        ->check(CLI::IsMember({"graph", "bezier", "linear"}));
    command.add_option("--seed", options.seed, "draws one of the candidate paths")
        ->capture_default_str();
    command.add_flag("--raw-feet", options.rawFeet, "standing feet are not held in place");
}

Sequence sequenceOf(const MotionLibrary& library, const std::vector<std::string>& names,
                    const TransitionOptions& options) {
    Sequence sequence;
    sequence.cleanFeet = !options.rawFeet;
    for (const std::string& name : names) {
        SequenceBlock& block = sequence.blocks.emplace_back(blockNamed(library, name));
        block.transition.seed = seedOf(options.seed, sequence.blocks.size() - 1);
        block.transition.method = methodNamed(options.method);
    }
    return sequence;
}

std::string transitionJson(const SequenceMotion& motion) {
    Json json = Json::object();
    for (const SequencePiece& piece : motion.pieces) {
        if (!piece.transition) continue;
        addReport(json, *piece.transition);
        json["begin"] = piece.frames.begin;
        json["end"] = piece.frames.end;
    }
    json["frames"] = motion.clip.frameCount();
    json["rate"] = motion.clip.rate;
    json["quality"] = qualityOf(motion);
    return text(json);
}

std::string sequenceJson(const Sequence& sequence, const SequenceMotion& motion) {
    Json pieces = Json::array();
    for (const SequencePiece& piece : motion.pieces) {
        Json entry = {{"block", piece.block},
                      {"clip", sequence.blocks[static_cast<std::size_t>(piece.block)].name},
                      {"kind", piece.transition ? "transition" : "action"},
                      {"begin", piece.frames.begin},
                      {"end", piece.frames.end}};
        if (piece.transition) addReport(entry, *piece.transition);
        pieces.push_back(std::move(entry));
    }
    return text({{"frames", motion.clip.frameCount()},
                 {"rate", motion.clip.rate},
                 {"quality", qualityOf(motion)},
                 {"pieces", std::move(pieces)}});
}

void printSequence(const MotionLibrary& library, const Sequence& sequence,
                   const SequenceMotion& motion, const Streams& streams) {
    for (const SequencePiece& piece : motion.pieces) {
        const std::string& name = sequence.blocks[static_cast<std::size_t>(piece.block)].name;
        streams.out << fmt::format("{:6}:{:<6} {:6.2f} s  ", piece.frames.begin, piece.frames.end,
                                   piece.frames.size() / library.rate);
        if (!piece.transition) {
            streams.out << name << "\n";
            continue;
        }
        const TransitionReport& report = *piece.transition;
        streams.out << fmt::format(
            "  {}: clusters {}{}\n", methodName(report.method), fmt::join(report.visited, " → "),
            report.chosen < 0 ? std::string()
                              : fmt::format(", cost {:.1f}, candidate {} of {}", report.cost(),
                                            report.chosen + 1, report.candidates.size()));
    }
}

}  // namespace kumite::cli
