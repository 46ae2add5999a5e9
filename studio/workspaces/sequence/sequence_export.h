#pragma once

#include <memory>

class QString;
class QWidget;

namespace kumite::studio {

class SequenceSession;

/// Keeps the motion as a take of the project, in the background; asks for the file.
void keepSequence(SequenceSession& sequence, QWidget* window);
void keepSequenceAs(SequenceSession& sequence, const QString& path);
/// Writes the motion, .bvh or .glb, in the background; asks for the file.
void exportSequence(SequenceSession& sequence, QWidget* window);
void exportSequenceTo(SequenceSession& sequence, const QString& path);
/// Asks for files whose clips the project shall hold.
void addSequenceClips(SequenceSession& sequence, QWidget* window);
/// The same, of a folder and all below it.
void addSequenceFolder(SequenceSession& sequence, QWidget* window);

}  // namespace kumite::studio
