#include "core/formats/tables.h"

#include <iterator>

#include <fmt/format.h>

namespace kumite {

std::string csvField(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string jointPositionsCsv(const Skeleton& skeleton, const JointPositions& positions,
                              int firstFrame, bool withEndSites) {
    std::string text = "frame,joint,x,y,z\n";
    auto out = std::back_inserter(text);
    for (int frame = 0; frame < positions.frameCount; ++frame) {
        for (int j = 0; j < skeleton.jointCount(); ++j) {
            const Joint& joint = skeleton.joints[static_cast<std::size_t>(j)];
            if (joint.isEndSite && !withEndSites) continue;
            const Eigen::Vector3f p = positions.at(frame, j);
            fmt::format_to(out, "{},{},{:.6f},{:.6f},{:.6f}\n", firstFrame + frame,
                           csvField(joint.name), p.x(), p.y(), p.z());
        }
    }
    return text;
}

}  // namespace kumite
