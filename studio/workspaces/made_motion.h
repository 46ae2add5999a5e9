#pragma once

#include <QString>

#include <memory>

#include "core/motion/motion_library.h"

class QWidget;

namespace kumite::studio {

class JobRunner;
class Session;

/// A motion that was made of a library, and what a file of it would be called.
struct MadeMotion {
    std::shared_ptr<const MotionLibrary> library;
    std::shared_ptr<const Clip> clip;
    QString name;
};

/// Keeps the motion as a take of the project, in the background; asks for the file.
void keepMotion(Session& session, JobRunner& writing, const MadeMotion& motion, QWidget* window);
void keepMotionAs(Session& session, JobRunner& writing, const MadeMotion& motion,
                  const QString& path);
/// Writes the motion, .bvh or .glb, in the background; asks for the file.
void exportMotion(Session& session, JobRunner& writing, const MadeMotion& motion, QWidget* window);
void exportMotionTo(Session& session, JobRunner& writing, const MadeMotion& motion,
                    const QString& path);
/// Asks for files whose clips the project shall hold.
void askForClips(Session& session, QWidget* window);
/// The same, of a folder and all below it.
void askForClipFolder(Session& session, QWidget* window);

}  // namespace kumite::studio
