// Prints when the contact force of a recording has its boundaries: minima RECORDING.bvh
#include <cstdio>
#include <exception>

#include "core/project/analysis.h"
#include "core/project/import.h"

int main(int argc, char** argv) try {
    if (argc != 2) return std::puts("usage: minima RECORDING.bvh"), 2;
    kumite::TakeRequest request;
    request.fighters.emplace_back().path = argv[1];
    kumite::Project project;
    project.takes.push_back(kumite::importTake(request).take);
    const kumite::Analysis analysis = kumite::analyse(project);
    const kumite::FighterAnalysis& fighter = analysis.at({0, 0});
    for (const kumite::Action& action : fighter.segmentation->actions)
        std::printf("%.3f s\n", action.begin / fighter.input.rate);
} catch (const std::exception& error) {
    std::fprintf(stderr, "minima: %s\n", error.what());
    return 1;
}
