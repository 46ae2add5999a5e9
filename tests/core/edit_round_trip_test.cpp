// Every edit × undo × redo × save × reopen equals the same project.

#include <algorithm>
#include <map>
#include <random>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/bvh.h"
#include "core/project/edits.h"
#include "core/project/history.h"
#include "core/project/import.h"
#include "core/project/project_file.h"
#include "tests/support/builders.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

using Random = std::mt19937;
/// An edit with arguments that are drawn.
using Draw = std::function<MaybeEdit(const Project&, const Analysis&, Random&)>;

int pick(Random& random, int count) {
    return std::uniform_int_distribution(0, count - 1)(random);
}

double number(Random& random, double from, double to) {
    return std::uniform_real_distribution(from, to)(random);
}

FighterAddress fighter(const Project& project, Random& random) {
    const int take = pick(random, static_cast<int>(project.takes.size()));
    const auto& fighters = project.takes[static_cast<std::size_t>(take)].fighters;
    return {take, pick(random, static_cast<int>(fighters.size()))};
}

int anyTake(const Project& project, Random& random) {
    return pick(random, static_cast<int>(project.takes.size()));
}

int boundary(const Analysis& analysis, FighterAddress address, Random& random) {
    const auto& boundaries = analysis.at(address).segmentation->boundaries;
    return boundaries[static_cast<std::size_t>(pick(random, static_cast<int>(boundaries.size())))]
        .frame;
}

std::optional<Correction> correction(const Project& project, FighterAddress address,
                                     Correction::Kind kind, Random& random) {
    std::vector<Correction> found;
    for (const Correction& each : fighterAt(project, address).corrections) {
        if (each.kind == kind) found.push_back(each);
    }
    if (found.empty()) return std::nullopt;
    return found[static_cast<std::size_t>(pick(random, static_cast<int>(found.size())))];
}

std::string letters(Random& random) {
    std::string name = "take ";
    for (int i = 0; i < 4; ++i)
        name += "abc\"\\ \xC3\xA9"[pick(random, 6)];
    return name;
}

/// All edits of edits.h by name.
const std::map<std::string, Draw>& edits() {
    static const std::map<std::string, Draw> all = {
        {"removeBoundary",
         [](const Project& p, const Analysis& a, Random& r) {
             const auto f = fighter(p, r);
             return removeBoundary(p, a, f, boundary(a, f, r));
         }},
        {"restoreBoundary",
         [](const Project& p, const Analysis& a, Random& r) -> MaybeEdit {
             const auto f = fighter(p, r);
             const auto& removed = a.at(f).segmentation->removed;
             if (removed.empty()) return std::nullopt;
             return restoreBoundary(p, a, f, removed.front().frame);
         }},
        {"addBoundary",
         [](const Project& p, const Analysis& a, Random& r) {
             const auto f = fighter(p, r);
             return addBoundary(p, a, f, 1 + pick(r, a.at(f).frameCount() - 2));
         }},
        {"moveBoundary",
         [](const Project& p, const Analysis& a, Random& r) {
             const auto f = fighter(p, r);
             const int from = boundary(a, f, r);
             return moveBoundary(p, a, f, from, from + pick(r, 9) - 4);
         }},
        {"acceptBoundary",
         [](const Project& p, const Analysis& a, Random& r) {
             const auto f = fighter(p, r);
             return acceptBoundary(p, a, f, boundary(a, f, r));
         }},
        {"withdrawAcceptance",
         [](const Project& p, const Analysis& a, Random& r) -> MaybeEdit {
             const auto f = fighter(p, r);
             const auto kept = correction(p, f, Correction::Kind::Keep, r);
             return kept ? withdrawAcceptance(p, a, f, kept->frame) : std::nullopt;
         }},
        {"forgetCorrection",
         [](const Project& p, const Analysis& a, Random& r) -> MaybeEdit {
             const auto f = fighter(p, r);
             const auto& unmatched = a.at(f).segmentation->unmatched;
             if (unmatched.empty()) return std::nullopt;
             return forgetCorrection(p, a, f, unmatched.front());
         }},
        {"addBoundaryOfCorrection",
         [](const Project& p, const Analysis& a, Random& r) -> MaybeEdit {
             const auto f = fighter(p, r);
             const auto& unmatched = a.at(f).segmentation->unmatched;
             if (unmatched.empty()) return std::nullopt;
             return addBoundaryOfCorrection(p, a, f, unmatched.front());
         }},
        {"setNote",
         [](const Project& p, const Analysis& a, Random& r) {
             const auto f = fighter(p, r);
             return setNote(p, a, f, pick(r, a.at(f).frameCount()),
                            pick(r, 3) ? letters(r) : std::string());
         }},
        {"addClips",
         [](const Project& p, const Analysis&, Random& r) {
             return addClips(p, {"/clips/" + std::to_string(pick(r, 30)), "/clips/kick.bvh"});
         }},
        {"removeClips",
         [](const Project& p, const Analysis&, Random& r) -> MaybeEdit {
             if (p.clips.empty()) return std::nullopt;
             return removeClips(
                 p, {p.clips[static_cast<std::size_t>(pick(r, static_cast<int>(p.clips.size())))]});
         }},
        {"setDraft",
         [](const Project& p, const Analysis&, Random& r) {
             return setDraft(p, pick(r, 2) ? "keys" : "sequence",
                             pick(r, 3) ? "[" + std::to_string(pick(r, 9)) + "]" : std::string(),
                             "Draft");
         }},
        {"dropUnmatchedCorrections",
         [](const Project& p, const Analysis& a, Random& r) {
             return dropUnmatchedCorrections(p, a, fighter(p, r));
         }},
        {"setSegmentation",
         [](const Project& p, const Analysis&, Random& r) {
             return setSegmentation(p, {number(r, 4, 8), number(r, 0.01, 0.2),
                                        pick(r, 2) ? ForceCurve::Norm : ForceCurve::Vertical});
         }},
        {"setBodyModel",
         [](const Project& p, const Analysis&, Random& r) {
             BodyModel model = deLevaMale();
             model.name = letters(r);
             return setBodyModel(p, model);
         }},
        {"restoreVersion",
         [](const Project& p, const Analysis&, Random& r) {
             Project version = p;
             version.segmentation.cutoff = number(r, 4, 8);
             return restoreVersion(p, version, "10:32");
         }},
        {"addTake",
         [](const Project& p, const Analysis&, Random& r) {
             Take take = p.takes[static_cast<std::size_t>(anyTake(p, r))];
             take.name = letters(r);
             if (pick(r, 2) == 0) take.fighters.pop_back();
             if (take.fighters.empty()) take = p.takes.front(), take.name = letters(r);
             return addTake(p, take);
         }},
        {"removeTake",
         [](const Project& p, const Analysis&, Random& r) -> MaybeEdit {
             if (p.takes.size() < 2) return std::nullopt;
             return removeTake(p, anyTake(p, r));
         }},
        {"moveTake", [](const Project& p, const Analysis&,
                        Random& r) { return moveTake(p, anyTake(p, r), anyTake(p, r)); }},
        {"renameTake", [](const Project& p, const Analysis&,
                          Random& r) { return renameTake(p, anyTake(p, r), letters(r)); }},
        {"swapFighters", [](const Project& p, const Analysis&,
                            Random& r) { return swapFighters(p, anyTake(p, r)); }},
        {"setOffset", [](const Project& p, const Analysis&,
                         Random& r) { return setOffset(p, fighter(p, r), number(r, -3, 3)); }},
        {"setPlacement",
         [](const Project& p, const Analysis&, Random& r) {
             return setPlacement(p, fighter(p, r),
                                 {number(r, -2, 2), number(r, -2, 2), number(r, -4, 4)});
         }},
        {"setFloor",
         [](const Project& p, const Analysis&, Random& r) {
             return setFloor(p, fighter(p, r),
                             pick(r, 2) ? std::optional(number(r, -0.1, 0.1)) : std::nullopt);
         }},
        {"setRole",
         [](const Project& p, const Analysis&, Random& r) {
             const Role role = allRoles()[static_cast<std::size_t>(pick(r, kRoleCount))];
             return setRole(p, fighter(p, r), role,
                            pick(r, 3) ? std::optional(pick(r, 20)) : std::nullopt);
         }},
        {"relinkRecording",
         [](const Project& p, const Analysis&, Random& r) {
             const auto f = fighter(p, r);
             const auto from = fighter(p, r);
             return relinkRecording(p, f, fighterAt(p, from).recording, fighterAt(p, from).motion);
         }},
    };
    return all;
}

/// A bout whose recordings are files.
struct BoutOnDisk {
    test::TemporaryFolder folder;
    std::filesystem::path file = folder / "bout.kumite";
    Project project;

    BoutOnDisk() {
        TakeRequest request;
        request.name = "made";
        for (const int player : {0, 1}) {
            const auto motion =
                test::bobbing(240, 60, [player](double t) { return test::boutHeight(player, t); });
            const auto path = folder / (player == 0 ? "red.bvh" : "blue.bvh");
            test::writeText(path, bvhText(*motion, motion->frames(), motion->frameTime));
            request.fighters.emplace_back().path = path;
        }
        project.takes.push_back(importTake(request).take);
    }
};

/// The project as it is on the disk and in the analysis: motions by what they hold.
void expectSame(const Project& a, Project b, const std::string& after) {
    ASSERT_EQ(a.takes.size(), b.takes.size()) << after;
    for (std::size_t t = 0; t < a.takes.size(); ++t) {
        ASSERT_EQ(a.takes[t].fighters.size(), b.takes[t].fighters.size()) << after;
        for (std::size_t p = 0; p < a.takes[t].fighters.size(); ++p) {
            const Fighter& kept = a.takes[t].fighters[p];
            Fighter& read = b.takes[t].fighters[p];
            ASSERT_TRUE(kept.motion && read.motion) << after;
            EXPECT_EQ(kept.motion->channels, read.motion->channels) << after;
            read.motion = kept.motion;
        }
    }
    EXPECT_EQ(a, b) << after;
}

TEST(EditRoundTrip, CoversEveryEdit) {
    const std::string header = test::readText(test::sourceFolder() / "core/project/edits.h");
    const std::regex declaration(R"(\nMaybeEdit (\w+)\()");
    std::set<std::string> declared;
    for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it)
        declared.insert((*it)[1]);
    std::set<std::string> tried;
    for (const auto& [name, draw] : edits())
        tried.insert(name);
    EXPECT_EQ(declared, tried);
}

TEST(EditRoundTrip, UndoRedoSaveAndReopenGiveTheSameProject) {
    const BoutOnDisk bout;
    std::map<std::string, int> done;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Random random(seed);
        History history(bout.project);
        Analysis analysis = analyse(bout.project);
        for (int step = 0; step < 120; ++step) {
            auto chosen = edits().begin();
            std::advance(chosen, pick(random, static_cast<int>(edits().size())));
            const Project before = history.current();
            MaybeEdit edit;
            try {
                edit = chosen->second(before, analysis, random);
            } catch (const Error&) {
                continue;  // refused with a sentence: nothing changed
            }
            if (!edit) continue;
            const std::string what =
                chosen->first + ", seed " + std::to_string(seed) + ", step " + std::to_string(step);
            ++done[chosen->first];
            const Project after = edit->project;
            EXPECT_FALSE(after == before) << what;
            history.commit(std::move(*edit));
            history.undo();
            EXPECT_EQ(history.current(), before) << what;
            history.redo();
            EXPECT_EQ(history.current(), after) << what;
            saveProject(after, bout.file);
            const LoadedProject reopened = loadProject(bout.file);
            expectSame(after, reopened.project, what);
            if (HasFatalFailure()) return;
            analysis = analyse(after, analysis);
            // Now and then a wrong role or wild threshold leaves nothing to correct.
            if (step % 12 == 11) {
                history.goTo(0);
                analysis = analyse(history.current(), analysis);
            }
        }
        // All the way back: not one step is lost.
        history.goTo(0);
        EXPECT_EQ(history.current(), bout.project);
    }
    for (const auto& [name, draw] : edits()) {
        // There is seldom a correction that means no minimum any more.
        if (name == "dropUnmatchedCorrections" || name == "forgetCorrection" ||
            name == "addBoundaryOfCorrection") {
            continue;
        }
        EXPECT_GT(done[name], 0) << name << " was never done";
    }
}

}  // namespace
}  // namespace kumite
