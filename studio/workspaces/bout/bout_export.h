#pragma once

#include <QImage>
#include <QString>

#include <functional>

#include "core/synthesis/bout_tape.h"

namespace kumite {
struct Project;
}

namespace kumite::studio {

/// Writes a bout by the file's suffix: .bvh (a pair, NAME-1 and NAME-2), .glb (skeletons and
/// animation), .json (the log that makes it again). Throws Error. For any thread.
void writeBout(const Project& project, const BoutTape& tape, const QString& path,
               const Progress& progress);

/// Frames as pictures. One call of `picture` a frame, in order; false from `goesOn` (share done)
/// stops.
struct FilmFrames {
    int count = 0;
    double rate = 30;  ///< Hz
    std::function<QImage(int)> picture;
    std::function<bool(double)> goesOn;
};
/// NAME-00001.png …: an error in a sentence, else empty.
QString writePictures(const FilmFrames& frames, const QString& path);
/// A video by the ffmpeg that is installed; the sentence says what to do where none is.
QString writeVideo(const FilmFrames& frames, const QString& path);

}  // namespace kumite::studio
