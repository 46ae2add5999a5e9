#pragma once

#include <QString>
#include <QStringList>

#include <filesystem>

#include "core/project/analysis.h"
#include "core/project/import.h"
#include "core/project/project.h"

namespace kumite::studio {

struct RecoveryCopy;

/// A project read from the disk with everything derived from it: what a job hands to the window.
struct OpenedProject {
    Project project;
    Analysis analysis;
    Findings findings;
    std::string fingerprint;  ///< of the project file as it was read; empty where there is none
};

/// Reads a project file and all its recordings. Throws Error. Any thread.
OpenedProject openProject(const QString& path, const Progress& progress);

/// The project of a recovery copy. Throws Error. Any thread.
OpenedProject openCopy(const RecoveryCopy& copy, const Progress& progress);

/// Makes recordings the only take of a new project; those in `known` were read before. Throws
/// Error. Any thread.
using Recordings = std::map<RecordingKey, ReadResult>;
OpenedProject openRecordings(const TakeRequest& request, const Recordings& known,
                             const Progress& progress);
/// The same as a take for a project that is open.
ImportedTake readTake(const TakeRequest& request, const Recordings& known,
                      const Progress& progress);

/// A request for one or two files with everything else left to be found.
TakeRequest requestFor(const QStringList& files);

bool isProjectFile(const QString& path);
std::filesystem::path toPath(const QString& path);
QString fromPath(const std::filesystem::path& path);

}  // namespace kumite::studio
