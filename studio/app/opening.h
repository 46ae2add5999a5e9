#pragma once

#include <QString>
#include <QStringList>

#include <filesystem>

#include "core/project/analysis.h"
#include "core/project/import.h"
#include "core/project/project.h"

namespace kumite::studio {

/// A project read from the disk with everything derived from it: what a job hands to the window.
struct OpenedProject {
    Project project;
    Analysis analysis;
    Findings findings;
    QString path;  ///< of the project file; empty where there is none yet
};

/// Reads a project file and all its recordings. Throws Error. Any thread.
OpenedProject openProject(const QString& path, const Progress& progress);

/// Reads recordings as the only take of a new project. Throws Error. Any thread.
OpenedProject openRecordings(const TakeRequest& request, const Progress& progress);

/// A request for one or two files with everything else left to be found.
TakeRequest requestFor(const QStringList& files);

bool isProjectFile(const QString& path);
std::filesystem::path toPath(const QString& path);
QString fromPath(const std::filesystem::path& path);

}  // namespace kumite::studio
