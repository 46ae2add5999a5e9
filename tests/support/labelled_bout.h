#pragma once

#include "core/project/demo_bout.h"
#include "core/project/interaction.h"
#include "core/project/label_files.h"
#include "core/project/project_file.h"

namespace kumite::test {

/// A made bout as a project with its true labels, and what is learnt from it. Its files lie in
/// `folder`.
struct LabelledBout {
    Project project;
    Analysis analysis;
    Interaction interaction;

    LabelledBout(const std::filesystem::path& folder, double seconds, std::uint64_t seed) {
        const DemoFiles files = writeDemoBout({seconds, 60, seed}, folder);
        project = loadProject(files.project()).project;
        analysis = analyse(project);
        const auto matched = matchLabels(
            project, analysis, readLabels(files.truth(), *project.labelling.vocabulary), 0);
        project = importLabels(project, analysis, matched.fighters)->project;
        analysis = analyse(project, analysis);
        interaction = deriveInteraction(project, analysis);
    }
};

}  // namespace kumite::test
