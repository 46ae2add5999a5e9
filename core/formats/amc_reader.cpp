#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/formats/amc.h"
#include "core/formats/scanner.h"

namespace kumite {
namespace {

class AmcReader {
public:
    AmcReader(std::string_view text, const std::string& name, const AsfSkeleton& asf,
              const Progress& progress)
        : scanner_(text, name), asf_(asf), progress_(progress), degrees_(asf.degrees) {}

    Recording read() {
        recording_.format = "ASF/AMC";
        motion_.skeleton = asf_.skeleton;
        motion_.frameTime = 0;
        readHeader();
        while (scanner_.skipSpace() && readFrame()) {
        }
        if (motion_.frameCount == 0) scanner_.failHere("at least one whole frame");
        if (motion_.frameTime == 0) assumeRate();
        progress_.update(1);
        recording_.motions.push_back(std::make_shared<const Motion>(std::move(motion_)));
        return std::move(recording_);
    }

private:
    void readHeader() {
        while (scanner_.peek().starts_with(':')) {
            if (scanner_.accept(":degrees")) {
                degrees_ = true;
            } else if (scanner_.accept(":radians")) {
                degrees_ = false;
            } else if (scanner_.accept(":samples-per-second")) {
                const double rate = scanner_.number("the number of samples per second");
                if (rate > 0) motion_.frameTime = 1.0 / rate;
            }
            scanner_.skipLine();
        }
    }

    void assumeRate() {
        motion_.frameTime = 1.0 / 120.0;
        recording_.findings.push_back(
            note("An AMC file does not say its frame rate: 120 Hz is assumed; give another with "
                 "--rate."));
    }

    /// False where the file ends within the frame, which is then dropped.
    bool readFrame() {
        constexpr int kFramesPerReport = 32;
        const std::size_t begin = scanner_.position();
        const auto number = parseInteger(scanner_.peek());
        if (!number) scanner_.failHere("the number of a frame");
        scanner_.next();
        checkNumber(*number);
        if (motion_.frameCount % kFramesPerReport == 0) {
            progress_.update(static_cast<double>(begin) /
                             static_cast<double>(scanner_.text().size()));
        }
        const auto width = static_cast<std::size_t>(asf_.skeleton->channelCount);
        const std::size_t row = motion_.channels.size();
        motion_.channels.resize(row + width);
        std::map<std::string_view, bool> seen;
        bool isCut = false;
        while (!isCut && scanner_.skipSpace() && !parseInteger(scanner_.peek())) {
            isCut = !readBone(*number, &motion_.channels[row], seen);
        }
        if (!isCut && seen.size() < asf_.lines.size()) {
            isCut = !scanner_.skipSpace();
            if (!isCut) failMissing(begin, *number, seen);
        }
        if (isCut) {
            motion_.channels.resize(row);
            recording_.findings.push_back(
                warning(fmt::format("Frame {}, the last, is cut: it is dropped.", *number)));
            return false;
        }
        ++motion_.frameCount;
        return true;
    }

    void checkNumber(int number) {
        const bool follows = !lastNumber_ || number == *lastNumber_ + 1;
        lastNumber_ = number;
        if (follows || hasGap_) return;
        hasGap_ = true;
        recording_.findings.push_back(
            warning(fmt::format("Frame {} does not follow the one before it by number: the frames "
                                "are taken one after the other.",
                                number)));
    }

    /// Reads the line of one bone into its columns of `row`; false where the file ends in it.
    bool readBone(int frame, double* row, std::map<std::string_view, bool>& seen) {
        const std::string_view name = scanner_.peek();
        const bool isLastWord = scanner_.position() + name.size() == scanner_.text().size();
        const auto line = asf_.lines.find(name);
        if (line == asf_.lines.end()) {
            if (isLastWord) return false;
            scanner_.failHere(fmt::format(
                "a bone of the skeleton that has a dof, or the number of the frame after {}",
                frame));
        }
        if (seen[line->first]) {
            scanner_.failHere(fmt::format("each bone once in frame {}", frame));
        }
        seen[line->first] = true;
        scanner_.next();
        for (std::size_t i = 0; i < line->second.size(); ++i) {
            if (!scanner_.moreOnLine()) {
                const std::size_t here = scanner_.position();
                if (!scanner_.skipSpace()) return false;
                scanner_.fail(here,
                              fmt::format("found {} numbers, expected {} for bone {} in "
                                          "frame {}",
                                          i, line->second.size(), inQuotes(line->first), frame));
            }
            const std::string_view word = scanner_.peek();
            double number = 0;
            const char* const end = word.data() + word.size();
            const bool atEnd = scanner_.position() + word.size() == scanner_.text().size();
            if (readNumber(word.data(), end, number) != end) {
                if (atEnd) return false;
                scanner_.failHere(
                    fmt::format("a number for bone {} in frame {}", inQuotes(line->first), frame));
            }
            scanner_.next();
            store(line->second[i], number, row);
        }
        if (scanner_.moreOnLine()) {
            scanner_.failHere(fmt::format("only {} numbers for bone {} in frame {}",
                                          line->second.size(), inQuotes(line->first), frame));
        }
        return true;
    }

    void store(const AmcValue& target, double number, double* row) const {
        if (target.column < 0) return;
        if (target.isAngle && !degrees_) number *= 180.0 / std::numbers::pi;
        // Adding zero would turn -0 into 0.
        row[target.column] = target.shift == 0 ? number : number + target.shift;
    }

    [[noreturn]] void failMissing(std::size_t position, int frame,
                                  const std::map<std::string_view, bool>& seen) {
        std::string missing;
        for (const auto& [name, line] : asf_.lines) {
            if (!seen.contains(name)) missing = name;
        }
        scanner_.fail(position, fmt::format("found no line for bone {} in frame {}, expected one "
                                            "for each bone with a dof",
                                            inQuotes(missing), frame));
    }

    Scanner scanner_;
    const AsfSkeleton& asf_;
    const Progress& progress_;
    bool degrees_;
    Recording recording_;
    Motion motion_;
    std::optional<int> lastNumber_;
    bool hasGap_ = false;
};

}  // namespace

Recording readAmc(std::string_view text, const std::string& name, const AsfSkeleton& asf,
                  const Progress& progress) {
    return AmcReader(text, name, asf, progress).read();
}

}  // namespace kumite
