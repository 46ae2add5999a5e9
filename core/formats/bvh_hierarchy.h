#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/base/finding.h"
#include "core/base/text.h"
#include "core/formats/scanner.h"
#include "core/motion/skeleton.h"

namespace kumite {

/// Reads one skeleton of a BVH's HIERARCHY: what follows the word ROOT up to the brace that
/// closes it. Keeps its own stack, so that no depth of nesting can exhaust the program's.
class BvhHierarchyReader {
public:
    BvhHierarchyReader(Scanner& scanner, Findings& findings)
        : scanner_(scanner), findings_(findings) {}

    Skeleton read() {
        open(readName("the name of the root joint"), false);
        while (!open_.empty())
            readStatement();
        for (Joint& joint : skeleton_.joints) {
            joint.firstChannel = skeleton_.channelCount;
            skeleton_.channelCount += static_cast<int>(joint.channels.size());
        }
        return std::move(skeleton_);
    }

private:
    /// A joint whose closing brace has not been seen yet.
    struct OpenJoint {
        std::size_t index = 0;
        bool hasOffset = false;
        bool hasChannels = false;
    };

    void readStatement() {
        if (scanner_.accept("}")) {
            close();
        } else if (scanner_.accept("OFFSET")) {
            readOffset();
        } else if (scanner_.accept("CHANNELS")) {
            readChannels();
        } else if (scanner_.accept("JOINT")) {
            becomeJoint();
            open(readName("the name of the joint"), false);
        } else if (scanner_.accept("End") || scanner_.accept("EndSite")) {
            scanner_.accept("Site");
            readRestOfNameLine();  // the name of an End Site, which tells nothing
            becomeJoint();
            open(joint().name + " End Site", true);
        } else {
            scanner_.failHere(fmt::format("OFFSET, CHANNELS, JOINT, End Site or }} in joint {}",
                                          inQuotes(joint().name)));
        }
    }

    void open(std::string name, bool isEndSite) {
        constexpr std::size_t kMostJoints = 10'000;
        if (skeleton_.joints.size() == kMostJoints) {
            scanner_.fail(scanner_.position(),
                          fmt::format("found more joints than a skeleton can have, expected {} "
                                      "at most",
                                      kMostJoints));
        }
        scanner_.expect("{");
        Joint joint;
        joint.name = std::move(name);
        joint.parent = open_.empty() ? -1 : static_cast<int>(open_.back().index);
        joint.isEndSite = isEndSite;
        open_.push_back({.index = skeleton_.joints.size()});
        skeleton_.joints.push_back(std::move(joint));
    }

    void close() {
        if (!open_.back().hasOffset) {
            findings_.push_back(
                warning(fmt::format("{} has no OFFSET: taken as 0 0 0.", inQuotes(joint().name))));
        }
        open_.pop_back();
    }

    /// An End Site that has children or channels is a joint, whatever it is called.
    void becomeJoint() {
        if (!joint().isEndSite) return;
        joint().isEndSite = false;
        findings_.push_back(note(
            fmt::format("{} has channels or children: read as a joint.", inQuotes(joint().name))));
    }

    void readOffset() {
        if (open_.back().hasOffset) failTwice("OFFSET");
        open_.back().hasOffset = true;
        for (double& value : joint().offset)
            value = scanner_.number("a number of the OFFSET");
    }

    void readChannels() {
        if (open_.back().hasChannels) failTwice("CHANNELS");
        open_.back().hasChannels = true;
        const auto count = parseInteger(scanner_.peek());
        if (!count || *count < 0 || *count > 6) {
            scanner_.failHere("the number of channels, 0 to 6");
        }
        scanner_.next();
        if (*count > 0) becomeJoint();
        std::vector<Channel>& channels = joint().channels;
        for (int i = 0; i < *count; ++i) {
            const Channel channel = readChannel(i, *count);
            if (std::find(channels.begin(), channels.end(), channel) != channels.end()) {
                scanner_.failHere("each channel once in a joint");
            }
            channels.push_back(channel);
            scanner_.next();
        }
        if (channelOf(scanner_.peek())) {
            scanner_.failHere(fmt::format("only the {} channels that CHANNELS announces", *count));
        }
    }

    Channel readChannel(int index, int count) {
        const auto channel = channelOf(scanner_.peek());
        if (channel) return *channel;
        scanner_.failHere(
            fmt::format("channel {} of {}: Xposition, Yposition, Zposition, "
                        "Xrotation, Yrotation or Zrotation",
                        index + 1, count));
    }

    static std::optional<Channel> channelOf(std::string_view word) {
        for (const Channel channel : {Channel::Xposition, Channel::Yposition, Channel::Zposition,
                                      Channel::Xrotation, Channel::Yrotation, Channel::Zrotation}) {
            if (equalsIgnoringCase(word, channelName(channel))) return channel;
        }
        return std::nullopt;
    }

    std::string readName(const std::string& expected) {
        std::string name(readRestOfNameLine());
        if (name.empty()) scanner_.failHere(expected);
        return name;
    }

    /// The rest of the line up to a brace that opens the joint's block: one that stands alone or
    /// ends the line. Names hold spaces, colons, anything else.
    std::string_view readRestOfNameLine() {
        const std::string_view rest = scanner_.restOfLine();
        std::size_t brace = rest.find('{');
        while (brace != std::string_view::npos && brace > 0 && !isSpace(rest[brace - 1])) {
            brace = rest.find('{', brace + 1);
        }
        if (brace == std::string_view::npos && rest.ends_with('{')) brace = rest.size() - 1;
        if (brace == std::string_view::npos) return rest;
        scanner_.moveTo(static_cast<std::size_t>(rest.data() - scanner_.text().data()) + brace);
        return trimmed(rest.substr(0, brace));
    }

    [[noreturn]] void failTwice(std::string_view what) const {
        scanner_.fail(scanner_.position() - what.size(),
                      fmt::format("found a second {}, expected one in joint {}", what,
                                  inQuotes(skeleton_.joints[open_.back().index].name)));
    }

    Joint& joint() { return skeleton_.joints[open_.back().index]; }

    Scanner& scanner_;
    Findings& findings_;
    Skeleton skeleton_;
    std::vector<OpenJoint> open_;
};

}  // namespace kumite
