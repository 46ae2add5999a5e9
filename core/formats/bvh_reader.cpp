#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/formats/bvh.h"
#include "core/formats/bvh_hierarchy.h"
#include "core/formats/number.h"
#include "core/formats/scanner.h"

namespace kumite {
namespace {

/// `Frames:` and `Frame Time:` as the file says them.
struct MotionHeader {
    std::optional<double> frames;
    std::optional<double> frameTime;
};

class BvhReader {
public:
    BvhReader(std::string_view text, const std::string& name, const Progress& progress)
        : scanner_(text, name), progress_(progress) {}

    Recording read() {
        recording_.format = "BVH";
        if (!equalsIgnoringCase(scanner_.peek(), "HIERARCHY")) scanner_.failHere("HIERARCHY");
        while (scanner_.skipSpace())
            readSection();
        if (recording_.motions.size() > 1) {
            recording_.findings.push_back(note(
                fmt::format("The file holds {} skeletons: {}. The first is read unless --root "
                            "names another.",
                            recording_.motions.size(), fmt::join(rootNames(recording_), ", "))));
        }
        progress_.update(1);
        return std::move(recording_);
    }

private:
    /// One or more skeletons and the MOTION that they share. Some files have several of these.
    void readSection() {
        const std::size_t begin = scanner_.position();
        std::vector<Skeleton> skeletons = readHierarchies();
        int width = 0;
        for (const Skeleton& skeleton : skeletons)
            width += skeleton.channelCount;
        if (width == 0) {
            scanner_.fail(begin, "found a skeleton without any channel, expected CHANNELS");
        }
        const double frameTime = readHeader();
        const std::size_t numbersBegin = scanner_.position();
        std::vector<double> values = readNumbers(width);
        const int frames = frameCount(values.size(), width, numbersBegin);
        addMotions(std::move(skeletons), std::move(values), width, frames, frameTime);
    }

    std::vector<Skeleton> readHierarchies() {
        std::vector<Skeleton> skeletons;
        for (;;) {
            if (scanner_.accept("HIERARCHY")) continue;
            if (scanner_.accept("ROOT")) {
                skeletons.push_back(BvhHierarchyReader(scanner_, recording_.findings).read());
            } else if (!skeletons.empty() && scanner_.accept("MOTION")) {
                return skeletons;
            } else {
                scanner_.failHere(skeletons.empty() ? "ROOT" : "MOTION");
            }
        }
    }

    /// The lines between MOTION and the numbers. Returns the frame time to use.
    double readHeader() {
        header_ = {};
        for (;;) {
            if (acceptKey("Frames")) {
                header_.frames = scanner_.number("the number of frames");
            } else if (acceptKey("Frame Time")) {
                header_.frameTime = scanner_.number("the frame time in seconds");
            } else {
                break;
            }
        }
        if (!header_.frameTime) scanner_.failHere(header_.frames ? "Frame Time:" : "Frames:");
        return usableFrameTime(*header_.frameTime);
    }

    /// Takes `key` and its colon; letters in any case, any or no blanks between words.
    bool acceptKey(std::string_view key) {
        scanner_.skipSpace();
        const std::string_view text = scanner_.text();
        std::size_t at = scanner_.position();
        const auto skipBlanks = [&] {
            while (at < text.size() && (text[at] == ' ' || text[at] == '\t'))
                ++at;
        };
        for (const std::string_view word : split(key, ' ')) {
            skipBlanks();
            if (!equalsIgnoringCase(text.substr(at, word.size()), word)) return false;
            at += word.size();
        }
        if (at < text.size() && isLetter(text[at])) return false;
        skipBlanks();
        if (at < text.size() && text[at] == ':') ++at;
        scanner_.moveTo(at);
        return true;
    }

    double usableFrameTime(double frameTime) {
        constexpr double kAssumed = 1.0 / 30.0;
        constexpr double kShortest = 1e-6;
        constexpr double kLongest = 1e6;
        if (frameTime < kShortest || frameTime > kLongest) {
            warn(
                "The frame time {} cannot be: 30 frames a second are assumed; give the true "
                "rate with --rate.",
                shortest(frameTime));
            return kAssumed;
        }
        if (rateOf(frameTime) < 10 || rateOf(frameTime) > 1000) {
            warn(
                "The frame time {} means {} frames a second, which is unusual; give the true "
                "rate with --rate if it is wrong.",
                shortest(frameTime), shortest(rateOf(frameTime)));
        }
        return frameTime;
    }

    /// All numbers up to the end or the next section, however they are spread over lines.
    std::vector<double> readNumbers(int width) {
        constexpr std::ptrdiff_t kProgressStep = std::ptrdiff_t{64} * 1024;
        const std::string_view text = scanner_.text();
        const char* const begin = text.data();
        const char* const end = begin + text.size();
        const char* at = begin + scanner_.position();
        const char* report = at;
        std::vector<double> values;
        // A header may promise anything, but a number takes at least two bytes.
        values.reserve(static_cast<std::size_t>(std::clamp(header_.frames.value_or(0) * width, 0.0,
                                                           static_cast<double>(end - at) / 2 + 1)));
        for (;;) {
            while (at != end && isSpace(*at))
                ++at;
            if (at == end) break;
            double value = 0;
            const char* const after = readNumber(at, end, value);
            if (after == nullptr || (after != end && !isSpace(*after))) {
                scanner_.moveTo(static_cast<std::size_t>(at - begin));
                if (!continuesAfterOddity()) return values;
                at = begin + scanner_.position();
                continue;
            }
            values.push_back(value);
            at = after;
            if (at >= report) {
                progress_.update(static_cast<double>(at - begin) /
                                 static_cast<double>(text.size()));
                report = at + kProgressStep;
            }
        }
        scanner_.moveTo(text.size());
        return values;
    }

    /// What stands among the numbers and is none: a comment (true, behind it), the next section
    /// or the stump of a number at the cut end of the file (false). All else is an error.
    bool continuesAfterOddity() {
        const std::size_t before = scanner_.position();
        const std::string_view token = scanner_.peek();
        if (scanner_.position() != before || token.empty()) return true;
        if (equalsIgnoringCase(token, "HIERARCHY") || equalsIgnoringCase(token, "ROOT")) {
            return false;
        }
        const bool touchesEnd = before + token.size() == scanner_.text().size();
        if (touchesEnd && token.find_first_not_of("+-.0123456789eE") == std::string_view::npos) {
            scanner_.moveTo(scanner_.text().size());
            return false;
        }
        scanner_.failHere("a finite number with a decimal point");
    }

    /// How many frames to keep: the numbers decide, the header only limits them.
    int frameCount(std::size_t numbers, int width, std::size_t numbersBegin) {
        const std::size_t present = numbers / static_cast<std::size_t>(width);
        const std::size_t left = numbers % static_cast<std::size_t>(width);
        if (present == 0) {
            scanner_.fail(numbersBegin, fmt::format("found {} numbers after Frame Time, expected "
                                                    "at least one frame of {} numbers",
                                                    numbers, width));
        }
        if (present > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            scanner_.fail(numbersBegin, "found more frames than can be counted, expected fewer");
        }
        const auto rows = static_cast<double>(present);
        const double said = header_.frames.value_or(0);
        if (!header_.frames) {
            warn("The header does not say how many frames there are: all {} are used.", present);
        } else if (said < 1) {
            warn("The header says {} frames: all {} that are there are used.", shortest(said),
                 present);
        } else if (said > rows) {
            warn("The header says {} frames but the file holds {}: these are used.", shortest(said),
                 present);
        } else if (said < rows) {
            warn("The header says {} frames but the file holds {}: the surplus is dropped.",
                 shortest(said), present);
            return static_cast<int>(said);
        }
        if (left > 0) {
            warn("The last frame is cut ({} of {} numbers): it is dropped.", left, width);
        }
        return static_cast<int>(present);
    }

    void addMotions(std::vector<Skeleton> skeletons, std::vector<double> values, int width,
                    int frames, double frameTime) {
        std::ptrdiff_t firstColumn = 0;
        for (Skeleton& skeleton : skeletons) {
            const int columns = skeleton.channelCount;
            if (columns == 0) {
                warn("The skeleton of {} has no channels: it is left out.",
                     inQuotes(skeleton.joints.front().name));
                continue;
            }
            auto motion = std::make_shared<Motion>();
            motion->frameTime = frameTime;
            motion->frameCount = frames;
            const std::size_t size =
                static_cast<std::size_t>(frames) * static_cast<std::size_t>(columns);
            if (columns == width) {
                motion->channels = std::exchange(values, {});
                motion->channels.resize(size);
            } else {
                motion->channels.reserve(size);
                for (std::ptrdiff_t frame = 0; frame < frames; ++frame) {
                    const auto row = values.begin() + frame * width + firstColumn;
                    motion->channels.insert(motion->channels.end(), row, row + columns);
                }
                firstColumn += columns;
            }
            motion->skeleton = std::make_shared<const Skeleton>(std::move(skeleton));
            recording_.motions.push_back(std::move(motion));
        }
    }

    template <typename... Arguments>
    void warn(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        recording_.findings.push_back(
            warning(fmt::format(text, std::forward<Arguments>(arguments)...)));
    }

    Scanner scanner_;
    const Progress& progress_;
    Recording recording_;
    MotionHeader header_;
};

}  // namespace

Recording readBvh(std::string_view text, const std::string& name, const Progress& progress) {
    return BvhReader(text, name, progress).read();
}

}  // namespace kumite
