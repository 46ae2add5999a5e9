#include "core/formats/tables.h"

#include <iterator>

#include <fmt/format.h>

#include "core/base/error.h"

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

std::vector<CsvLine> parseCsv(std::string_view text, const std::string& file) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<CsvLine> lines;
    int number = 1;
    CsvLine line{1, {}};
    std::string field;
    bool quoted = false;
    const auto endField = [&] {
        line.fields.push_back(std::move(field));
        field.clear();
    };
    const auto endLine = [&] {
        if (!field.empty() && field.back() == '\r') field.pop_back();
        endField();
        const bool empty = line.fields.size() == 1 && line.fields.front().empty();
        if (!empty) lines.push_back(std::move(line));
        line = {number, {}};
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') ++number;
        if (quoted) {
            if (c != '"') {
                field += c;
            } else if (i + 1 < text.size() && text[i + 1] == '"') {
                field += text[++i];
            } else {
                quoted = false;
            }
        } else if (c == '"' && field.empty()) {
            quoted = true;
        } else if (c == ',') {
            endField();
        } else if (c == '\n') {
            endLine();
        } else {
            field += c;
        }
    }
    if (quoted) throw InputError(file, line.number, 0, "has a quote that is not closed.");
    endLine();
    return lines;
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
