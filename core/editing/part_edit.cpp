#include "core/editing/part_edit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/editing/assembly.h"
#include "core/motion/blend.h"

namespace kumite {

Clip withPart(const Clip& take, const Clip& source, const PartEdit& edit) {
    const FrameRange range = edit.frames;
    if (range.empty() || range.begin < 0 || range.end > take.frameCount()) {
        throw Error(fmt::format("Frames {}:{} are not in the take, which has {}.", range.begin,
                                range.end, take.frameCount()));
    }
    if (take.rig->jointCount() != source.rig->jointCount())
        throw Error("The part comes from another skeleton.");
    const double last = source.frameCount() - 1;
    if (!(edit.sourceBegin >= 0 && edit.sourceBegin <= edit.sourceEnd && edit.sourceEnd <= last)) {
        throw Error(fmt::format("Frames {:g} to {:g} are not in the source, which has {}.",
                                edit.sourceBegin, edit.sourceEnd, source.frameCount()));
    }
    std::vector<int> parents;
    for (const Rig::Joint& joint : take.rig->joints)
        parents.push_back(joint.parent);
    const auto parts = partsOfJoints(parents, take.rig->roles);
    const auto junctions =
        edit.adjusted ? junctionJoints(*take.rig, edit.part) : std::vector<int>{};

    const int count = range.size();
    std::vector<Pose> shown;
    for (int i = 0; i < count; ++i) {
        const double way = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        const double frame = edit.sourceBegin + way * (edit.sourceEnd - edit.sourceBegin);
        shown.push_back(poseAt(source, frame / source.rate));
    }
    for (const int joint : junctions) {
        const auto j = static_cast<std::size_t>(joint);
        std::vector<Eigen::Quaterniond> retrieved, wanted;
        for (int i = 0; i < count; ++i) {
            retrieved.push_back(shown[static_cast<std::size_t>(i)].turns[j]);
            wanted.push_back(take.frames[static_cast<std::size_t>(range.begin + i)].turns[j]);
        }
        adjustJoint(retrieved, wanted);
        for (int i = 0; i < count; ++i)
            shown[static_cast<std::size_t>(i)].turns[j] = retrieved[static_cast<std::size_t>(i)];
    }
    Clip result = take;
    // The first and last frame still show the take, unless the range begins or ends with it.
    const double ease = std::max(1.0, std::round(edit.ease * take.rate));
    const bool fromStart = range.begin == 0, toEnd = range.end == take.frameCount();
    for (int i = 0; i < count; ++i) {
        const double in = fromStart ? 1.0 : std::min(1.0, i / ease);
        const double out = toEnd ? 1.0 : std::min(1.0, (count - 1 - i) / ease);
        const double share = eased(Easing::Smooth, std::min(in, out));
        Pose& pose = result.frames[static_cast<std::size_t>(range.begin + i)];
        for (std::size_t j = 0; j < parts.size(); ++j) {
            if (parts[j] != edit.part || share == 0) continue;
            pose.turns[j] = pose.turns[j].slerp(share, shown[static_cast<std::size_t>(i)].turns[j]);
        }
    }
    return result;
}

}  // namespace kumite
