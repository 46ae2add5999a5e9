#include "core/project/import.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/formats/json_text.h"
#include "core/project/recordings.h"

namespace kumite {
namespace {

/// A fighter on the way into a take.
struct Candidate {
    Fighter fighter;
    Survey survey;
};

int namedJoint(const Skeleton& skeleton, const std::string& name, const std::string& file) {
    const int joint = skeleton.find(name);
    if (joint >= 0) return joint;
    std::string known;
    for (const Joint& j : skeleton.joints) {
        if (!j.isEndSite) known += (known.empty() ? "" : ", ") + j.name;
    }
    throw Error(file + ": there is no joint named \"" + name + "\"; there is: " + known + ".");
}

/// A path that a project file can hold: absolute, links resolved, and text.
std::filesystem::path storable(const std::filesystem::path& path) {
    std::filesystem::path canonical = std::filesystem::weakly_canonical(path);
    if (asStored(canonical.string()) != canonical.string()) {
        throw Error(canonical.string() +
                    ": the name holds bytes that are no UTF-8 text; rename the file or folder.");
    }
    return canonical;
}

Candidate makeCandidate(const FighterRequest& request, const Recording& recording,
                        std::optional<double> rate) {
    Candidate candidate;
    Fighter& fighter = candidate.fighter;
    fighter.motion = motionOfRoot(recording, request.root);
    fighter.recording = referTo(recording, request.path, request.root);
    candidate.survey = surveyMotion(*fighter.motion, {request.metresPerUnit, request.up, rate});
    fighter.space = candidate.survey.space;
    fighter.rate = candidate.survey.rate;
    fighter.roles = candidate.survey.roles.roles;
    for (const auto& [role, name] : request.roles) {
        if (name.empty()) {
            fighter.roles.clear(role);
            continue;
        }
        fighter.roles.set(
            role, namedJoint(*fighter.motion->skeleton, name, request.path.filename().string()));
    }
    fighter.offset = request.offset;
    fighter.placement = request.placement;
    fighter.floor = request.floor;
    return candidate;
}

/// Frames of each file that belong to the take.
void chooseFrames(std::vector<Candidate>& candidates, const std::optional<FrameRange>& trim,
                  Findings& findings) {
    if (trim) {
        int longest = 0;
        for (const Candidate& c : candidates) {
            longest = std::max(longest, c.fighter.motion->frameCount);
        }
        for (Candidate& c : candidates) {
            const int count = c.fighter.motion->frameCount;
            const int end = trim->end < 0 ? count : std::min(trim->end, count);
            if (trim->begin < 0 || trim->begin >= end || trim->end > longest) {
                throw Error(
                    fmt::format("{}: frames {}:{} cannot be taken from a recording of {} frames.",
                                c.fighter.recording.path.filename().string(), trim->begin,
                                trim->end < 0 ? std::string() : std::to_string(trim->end), count));
            }
            c.fighter.frames = {trim->begin, end};
            if (trim->end > count) {
                findings.push_back(warning(
                    fmt::format("{}: holds {} frames only; the take ends there for this fighter.",
                                c.fighter.recording.path.filename().string(), count)));
            }
        }
        return;
    }
    // Two files of one length and rate were recorded together: trimming one alone would shift it
    // against the other.
    const bool together =
        candidates.size() == 2 &&
        candidates[0].fighter.motion->frameCount == candidates[1].fighter.motion->frameCount &&
        candidates[0].fighter.rate == candidates[1].fighter.rate;
    int shared = 0;
    for (const Candidate& c : candidates)
        shared = std::max(shared, c.survey.leadingRestFrames);
    for (Candidate& c : candidates) {
        const int begin = together ? shared : c.survey.leadingRestFrames;
        c.fighter.frames = {begin, c.fighter.motion->frameCount};
    }
}

}  // namespace

RecordingRef referTo(const Recording& recording, const std::filesystem::path& path,
                     const std::string& root) {
    return {storable(path), recording.asf.empty() ? recording.asf : storable(recording.asf),
            recording.sha256, root};
}

std::vector<RecordingKey> recordingsOf(const TakeRequest& request) {
    std::vector<RecordingKey> keys;
    for (const FighterRequest& fighter : request.fighters) {
        keys.push_back({fighter.path, fighter.asf.value_or(std::filesystem::path())});
    }
    return keys;
}

ImportedTake importTake(const TakeRequest& request, const Progress& progress) {
    const auto recordings = readRecordings(recordingsOf(request), progress.part(0.0, 0.9));
    ImportedTake imported = makeTake(request, recordings);
    progress.update(1.0);
    return imported;
}

ImportedTake makeTake(const TakeRequest& request,
                      const std::map<RecordingKey, ReadResult>& recordings) {
    if (request.fighters.empty() || request.fighters.size() > 2) {
        throw Error("A take is made of one or two recordings.");
    }
    if (asStored(request.name) != request.name) {
        throw Error("The take's name holds bytes that are no UTF-8 text.");
    }
    if (request.rate && !(*request.rate >= 1 && *request.rate <= 10000)) {
        throw Error("A frame rate lies between 1 and 10000 Hz.");
    }
    const std::vector<RecordingKey> keys = recordingsOf(request);
    ImportedTake imported;
    imported.take.name =
        request.name.empty() ? request.fighters.front().path.stem().string() : request.name;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const ReadResult& read = recordings.at(keys[i]);
        if (!read.recording) throw Error(read.error);
        candidates.push_back(makeCandidate(request.fighters[i], *read.recording, request.rate));
        const std::string file = request.fighters[i].path.filename().string() + ": ";
        Findings findings = read.recording->findings;
        const Findings& surveyed = candidates.back().survey.findings;
        findings.insert(findings.end(), surveyed.begin(), surveyed.end());
        for (const Finding& finding : findings) {
            imported.findings.push_back({finding.severity, file + finding.text});
        }
    }
    chooseFrames(candidates, request.trim, imported.findings);
    if (candidates.size() == 2 && candidates[0].fighter.rate != candidates[1].fighter.rate) {
        imported.findings.push_back(
            warning(fmt::format("The recordings run at {:g} and {:g} Hz; each keeps its own rate.",
                                candidates[0].fighter.rate, candidates[1].fighter.rate)));
    }
    for (Candidate& c : candidates) {
        imported.take.fighters.push_back(std::move(c.fighter));
        imported.surveys.push_back(std::move(c.survey));
    }
    return imported;
}

}  // namespace kumite
