#include "core/motion/contacts.h"

#include <algorithm>

#include "core/motion/feet.h"

namespace kumite {
namespace {

std::vector<std::uint8_t> contactOf(const Skeleton& skeleton, const RoleMap& roles, bool left,
                                    const JointPositions& positions, double rate,
                                    const ContactSettings& settings) {
    const auto foot = footPoint(skeleton, roles, left);
    if (!foot) return {};
    const auto rest = static_cast<float>(restHeight(positions, *foot));
    std::vector<float> height(static_cast<std::size_t>(positions.frameCount));
    for (int frame = 0; frame < positions.frameCount; ++frame) {
        height[static_cast<std::size_t>(frame)] = positions.data(frame, *foot)[1] - rest;
    }
    return footContact(height, jointSpeed(positions, *foot, rate), rate, settings);
}

}  // namespace

std::vector<std::uint8_t> footContact(std::span<const float> heightOverRest,
                                      std::span<const float> speed, double rate,
                                      const ContactSettings& settings) {
    const std::size_t frames = std::min(heightOverRest.size(), speed.size());
    std::vector<std::uint8_t> contact(frames, 0);
    bool standing = false;
    for (std::size_t i = 0; i < frames; ++i) {
        const double height = heightOverRest[i];
        standing = standing ? height <= settings.releaseHeight && speed[i] <= settings.releaseSpeed
                            : height < settings.height && speed[i] < settings.speed;
        contact[i] = standing;
    }
    // A run of n frames lasts n / rate seconds.
    const double fewest = settings.shortest * rate - 1e-9;
    for (auto begin = contact.begin(); begin != contact.end();) {
        const auto end = std::find_if(begin, contact.end(), [&](auto c) { return c != *begin; });
        if (*begin && static_cast<double>(end - begin) < fewest) std::fill(begin, end, 0);
        begin = end;
    }
    return contact;
}

FootContacts footContacts(const Skeleton& skeleton, const RoleMap& roles,
                          const JointPositions& positions, double rate,
                          const ContactSettings& settings) {
    return {contactOf(skeleton, roles, true, positions, rate, settings),
            contactOf(skeleton, roles, false, positions, rate, settings)};
}

}  // namespace kumite
