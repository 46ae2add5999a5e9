#pragma once

#include <filesystem>
#include <string>

#include "core/project/interaction.h"

namespace kumite {

/// All edges that were observed: `mover,kind,from,to,count,probability`; kind `own` (from the
/// mover's label, equation 10) or `cross` (from the opponent's, equation 11).
std::string graphCsv(const Interaction& interaction);

/// The whole graph: labels with their actions, transitions with their moments and surprise, action
/// table, counts (keys: core/project/README.md).
std::string graphJson(const Interaction& interaction);

/// Nodes and observed edges of both graphs and between them, for Gephi, yEd, NetworkX and others.
std::string graphGraphMl(const Interaction& interaction);

/// Writes one of these by the file's suffix: .csv, .json or .graphml. Throws Error.
void writeGraph(const Interaction& interaction, const std::filesystem::path& file);

}  // namespace kumite
