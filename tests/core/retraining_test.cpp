// The same labels train the same machine: after saving and opening again, and on any number of
// cores.
#include <gtest/gtest.h>

#ifdef __linux__
#include <sched.h>
#endif

#include "core/project/demo_bout.h"
#include "core/project/labelling.h"
#include "core/project/project_file.h"
#include "core/project/simulation.h"
#include "tests/support/fixtures.h"

namespace kumite {
namespace {

#ifdef __linux__
/// This thread, and those that it starts, on one core for a while; forBlocks then makes no other.
class OneCore {
public:
    OneCore() {
        sched_getaffinity(0, sizeof(before_), &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        for (int i = 0; i < CPU_SETSIZE; ++i) {
            if (!CPU_ISSET(i, &before_)) continue;
            CPU_SET(i, &one);
            break;
        }
        sched_setaffinity(0, sizeof(one), &one);
    }
    ~OneCore() { sched_setaffinity(0, sizeof(before_), &before_); }

private:
    cpu_set_t before_;
};
#else
struct OneCore {};
#endif

void expectSame(const AutoLabels& a, const AutoLabels& b) {
    EXPECT_EQ(a.model, b.model);
    EXPECT_EQ(a.expectedAccuracy, b.expectedAccuracy);
    ASSERT_EQ(a.proposals.fighters.size(), b.proposals.fighters.size());
    for (std::size_t i = 0; i < a.proposals.fighters.size(); ++i)
        EXPECT_EQ(a.proposals.fighters[i].labels, b.proposals.fighters[i].labels);
}

TEST(Retraining, GivesTheSameMachineBitForBit) {
    const test::TemporaryFolder folder;
    const DemoFiles files = writeDemoBout({20, 60, 5}, folder / "demo");
    Project project = loadProject(files.project()).project;
    Analysis analysis = analyse(project);
    std::vector<TimedLabel> labels = readLabels(files.truth(), kickboxing());
    for (std::size_t i = labels.size(); i-- > 0;) {
        if (i % 3 != 0) labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(i));
    }
    project =
        importLabels(project, analysis, matchLabels(project, analysis, labels).fighters)->project;
    const AutoLabels first = labelAutomatically(project, analysis);
    EXPECT_GT(first.examples, 10);
    expectSame(first, labelAutomatically(project, analysis));

    // Kept in the file with its settings: opened again, it is known and used without a search.
    project = setModel(project, first.model)->project;
    saveProject(project, folder / "demo" / "kept.kumite");
    const Project opened = loadProject(folder / "demo" / "kept.kumite").project;
    EXPECT_EQ(opened.labelling, project.labelling);
    expectSame(first, labelAutomatically(opened, analyse(opened)));

    // Another setting is another machine.
    LearningSettings plain;
    plain.mirrored = false;
    const Project other = setLearning(opened, plain)->project;
    EXPECT_NE(labelAutomatically(other, analyse(other)).model.trainingHash,
              first.model.trainingHash);

    const OneCore oneCore;
    const Project again = loadProject(folder / "demo" / "kept.kumite").project;
    const Analysis alone = analyse(again);
    EXPECT_EQ(actionTable(again, alone).features, actionTable(project, analysis).features);
    expectSame(first, labelAutomatically(again, alone));
}

}  // namespace
}  // namespace kumite
