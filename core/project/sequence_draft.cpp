#include "core/project/sequence_draft.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/json_text.h"
#include "core/project/library.h"
#include "core/project/library_strikes.h"

namespace kumite {
namespace {

using Json = nlohmann::ordered_json;

const std::string kKind = "sequence";

DraftBlock readBlock(const JsonReader& json) {
    DraftBlock block;
    block.clip = json["clip"].text();
    if (json.has("title")) block.title = json["title"].text();
    if (json.has("trim")) {
        block.trim = FrameRange{json["trim"].at(0).integer(), json["trim"].at(1).integer()};
        if (block.trim->begin < 0 || block.trim->empty())
            throw json["trim"].error("expected [begin, end] with 0 <= begin < end");
    }
    if (json.has("repeats")) block.repeats = json["repeats"].integer();
    if (block.repeats < 1 || block.repeats > 1000)
        throw json["repeats"].error("expected 1 to 1000");
    TransitionRequest& transition = block.transition;
    if (json.has("method")) {
        transition.method = methodNamed(json["method"].text());
        if (!transition.method)
            throw json["method"].error("expected \"graph\", \"bezier\" or \"linear\"");
    }
    if (json.has("seed")) {
        const int seed = json["seed"].integer();
        if (seed < 0) throw json["seed"].error("expected 0 or more");
        transition.seed = static_cast<std::uint64_t>(seed);
    }
    if (json.has("path")) {
        transition.path = json["path"].integer();
        if (*transition.path < 0) throw json["path"].error("expected 0 or more");
    }
    block.locked = json.has("locked") && json["locked"].boolean();
    return block;
}

Json blockJson(const DraftBlock& block) {
    const DraftBlock usual;
    Json json = {{"clip", asStored(block.clip)}};
    if (!block.title.empty()) json["title"] = asStored(block.title);
    if (block.trim) json["trim"] = {block.trim->begin, block.trim->end};
    if (block.repeats != 1) json["repeats"] = block.repeats;
    if (block.transition.method) json["method"] = methodName(*block.transition.method);
    if (block.transition.seed != usual.transition.seed) json["seed"] = block.transition.seed;
    if (block.transition.path) json["path"] = *block.transition.path;
    if (block.locked) json["locked"] = true;
    return json;
}

/// "C@x,y,z": the strike C made to hit that target.
std::shared_ptr<const LibraryMotion> strikeOf(const MotionLibrary& library, const std::string& name,
                                              const Eigen::Vector3d& target) {
    StrikeBlock block =
        strikeAt(library, actionNamed(library, name.substr(0, name.rfind('@'))), target);
    if (!block.hit.hits) {
        const Eigen::Vector3d& near = block.hit.reached;
        throw Error(fmt::format("\"{}\" cannot be reached: the nearest target that can is {}.",
                                name,
                                fmt::format("{:.2f},{:.2f},{:.2f}", near.x(), near.y(), near.z())));
    }
    block.motion.name = name;
    return std::make_shared<const LibraryMotion>(std::move(block.motion));
}

}  // namespace

std::string sequenceDraftText(const SequenceDraft& draft) {
    Json blocks = Json::array();
    for (const DraftBlock& block : draft.blocks)
        blocks.push_back(blockJson(block));
    Json json = {{"blocks", std::move(blocks)}};
    if (!draft.cleanFeet) json["clean_feet"] = false;
    return json.dump();
}

SequenceDraft parseSequenceDraft(std::string_view text, const std::string& file) {
    const Json json = parseJson(text, file);
    const JsonReader reader(json, file, "");
    SequenceDraft draft;
    const JsonReader blocks = reader["blocks"];
    for (std::size_t i = 0; i < blocks.size(); ++i)
        draft.blocks.push_back(readBlock(blocks.at(i)));
    draft.cleanFeet = !reader.has("clean_feet") || reader["clean_feet"].boolean();
    return draft;
}

SequenceDraft sequenceDraftOf(const Project& project) {
    const auto found = project.drafts.find(kKind);
    return found == project.drafts.end() ? SequenceDraft()
                                         : parseSequenceDraft(found->second, "draft " + kKind);
}

MaybeEdit setSequenceDraft(const Project& project, const SequenceDraft& draft, std::string edit) {
    return setDraft(project, kKind,
                    draft == SequenceDraft() ? std::string() : sequenceDraftText(draft),
                    std::move(edit));
}

SequenceBlock blockNamed(const MotionLibrary& library, const std::string& name) {
    SequenceBlock block;
    block.name = name;
    const auto sign = name.rfind('@');
    const auto target = sign == std::string::npos
                            ? std::nullopt
                            : targetFrom(std::string_view(name).substr(sign + 1));
    if (target) {
        block.made = strikeOf(library, name, *target);
    } else {
        block.action = actionNamed(library, name);
    }
    return block;
}

Sequence sequenceOf(const MotionLibrary& library, const SequenceDraft& draft,
                    const TransitionSettings& settings) {
    Sequence sequence;
    sequence.transitions = settings;
    sequence.cleanFeet = draft.cleanFeet;
    for (const DraftBlock& planned : draft.blocks) {
        SequenceBlock block = blockNamed(library, planned.clip);
        block.trim = planned.trim;
        block.repeats = planned.repeats;
        block.transition = planned.transition;
        sequence.blocks.push_back(std::move(block));
    }
    return sequence;
}

std::string lastingName(const MotionLibrary& library, const LibraryAction& action) {
    const LibraryMotion& motion = library.motions[static_cast<std::size_t>(action.motion)];
    const double perFrame = library.rate / motion.sourceRate;
    // Between the frames of a slower recording no frame of its own can be named.
    if (action.name == motion.name || perFrame > 1) return action.name;
    const auto begin = std::lround(action.frames.begin / perFrame);
    const auto last = static_cast<long>(std::ceil((action.frames.end - 1) / perFrame - 1e-6));
    return fmt::format("{}@{}:{}", motion.name, begin, last + 1);
}

}  // namespace kumite
