#include "core/motion/role_mapping.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/motion/role_names.h"
#include "core/motion/role_topology.h"

namespace kumite {
namespace {

using enum Role;

/// How many joints hang below each joint: of two joints of one name, the one that carries the
/// body is meant, not a marker or helper.
std::vector<int> descendantCounts(const Skeleton& skeleton) {
    std::vector<int> counts(skeleton.joints.size(), 0);
    for (std::size_t i = skeleton.joints.size(); i-- > 1;) {
        counts[static_cast<std::size_t>(skeleton.joints[i].parent)] += counts[i] + 1;
    }
    return counts;
}

/// A skeleton's names in the form that the families' tables know.
struct Names {
    std::vector<std::string> plain;
    std::vector<int> joints;  ///< index of the joint of each name; End Sites are left out
    std::vector<int> descendants;

    explicit Names(const Skeleton& skeleton) : descendants(descendantCounts(skeleton)) {
        std::vector<std::string_view> names;
        for (int i = 0; i < skeleton.jointCount(); ++i) {
            const Joint& joint = skeleton.joints[static_cast<std::size_t>(i)];
            if (joint.isEndSite) continue;
            names.push_back(joint.name);
            joints.push_back(i);
        }
        plain = plainJointNames(names);
    }

    template <typename Matches>
    std::optional<int> find(const Matches& matches) const {
        std::optional<int> best;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            if (!matches(plain[i])) continue;
            const auto carried = [&](int joint) {
                return descendants[static_cast<std::size_t>(joint)];
            };
            if (!best || carried(joints[i]) > carried(*best)) best = joints[i];
        }
        return best;
    }
};

RoleMap rolesByFamily(const Names& names, const NameFamily& family) {
    RoleMap roles;
    for (const auto& [role, bases] : family.entries) {
        const bool paired = mirrored(role) != role;
        for (const bool left : {true, false}) {
            if (!paired && !left) continue;
            const Role own = left ? role : mirrored(role);
            for (const std::string_view base : bases) {
                const auto joint = names.find([&](std::string_view plain) {
                    return paired ? isSided(plain, base, left) : plain == base;
                });
                if (!joint) continue;
                roles.set(own, *joint);
                break;
            }
        }
    }
    return roles;
}

bool hasBothLegs(const RoleMap& roles) {
    return roles.has(LeftHip) && roles.has(LeftKnee) && roles.has(LeftAnkle) &&
           roles.has(RightHip) && roles.has(RightKnee) && roles.has(RightAnkle);
}

bool hasBothArms(const RoleMap& roles) {
    return roles.has(LeftShoulder) && roles.has(LeftElbow) && roles.has(RightShoulder) &&
           roles.has(RightElbow);
}

void setIfMissing(RoleMap& roles, Role role, std::optional<int> joint) {
    if (!roles.has(role) && joint) roles.set(role, *joint);
}

/// Takes over from the shape what the names left open, but no joint that has a role already.
void fillGaps(RoleMap& roles, const RoleMap& shape) {
    for (const Role role : allRoles()) {
        const auto joint = shape[role];
        const bool taken = std::any_of(allRoles().begin(), allRoles().end(),
                                       [&](Role other) { return joint && roles[other] == joint; });
        if (!taken) setIfMissing(roles, role, joint);
    }
}

/// What follows from the limbs: trunk joints lie on the ways between them, and the last bone of a
/// chain ends at its End Site.
void completeFromTree(const Skeleton& skeleton, RoleMap& roles, Findings& findings) {
    if (roles.has(LeftHip) && roles.has(RightHip)) {
        setIfMissing(roles, Pelvis, commonAncestor(skeleton, *roles[LeftHip], *roles[RightHip]));
    }
    if (roles.has(LeftShoulder) && roles.has(RightShoulder)) {
        const int chest = commonAncestor(skeleton, *roles[LeftShoulder], *roles[RightShoulder]);
        if (chest != roles[Pelvis]) roles.set(Chest, chest);
        for (const Role shoulder : {LeftShoulder, RightShoulder}) {
            const std::vector<int> path = pathDown(skeleton, chest, *roles[shoulder]);
            if (path.size() < 2) continue;
            setIfMissing(roles, shoulder == LeftShoulder ? LeftClavicle : RightClavicle,
                         path[path.size() - 2]);
        }
    }
    if (roles.has(Pelvis) && roles.has(Chest)) {
        const std::vector<int> path = pathDown(skeleton, *roles[Pelvis], *roles[Chest]);
        if (path.size() > 1) roles.set(Spine, path.front());
    }
    if (roles.has(Head) && roles.has(Chest)) {
        const std::vector<int> path = pathDown(skeleton, *roles[Chest], *roles[Head]);
        if (path.size() > 1) setIfMissing(roles, Neck, path.front());
    }
    if (!roles.has(Neck) && roles.has(Chest)) {
        // A skeleton that ends at the shoulders: its top joint stands for the neck.
        roles.set(Neck, *roles[Chest]);
        findings.push_back(
            note(fmt::format("No neck: the chest ({}) stands in for it.",
                             skeleton.joints[static_cast<std::size_t>(*roles[Chest])].name)));
    }
    if (roles.has(Neck)) setIfMissing(roles, Head, endSiteOf(skeleton, *roles[Neck]));
    for (const bool left : {true, false}) {
        const auto side = [left](Role role) { return left ? role : mirrored(role); };
        if (roles.has(side(LeftElbow))) {
            setIfMissing(roles, side(LeftWrist), endSiteOf(skeleton, *roles[side(LeftElbow)]));
        }
        if (roles.has(side(LeftAnkle))) {
            setIfMissing(roles, side(LeftToe), endSiteOf(skeleton, *roles[side(LeftAnkle)]));
        }
    }
}

void reportMissing(const RoleMap& roles, Findings& findings) {
    std::string list;
    for (const Role role : roles.missing()) {
        // Many good skeletons have no separate spine or clavicles; nothing needs them.
        if (role == Spine || role == LeftClavicle || role == RightClavicle) continue;
        list += (list.empty() ? "" : ", ") + std::string(roleName(role));
    }
    if (!list.empty()) findings.push_back(warning("No joint was found for: " + list + "."));
}

}  // namespace

RoleMapping mapRoles(const Skeleton& skeleton) {
    const Names names(skeleton);
    RoleMapping mapping;
    for (const NameFamily& family : nameFamilies()) {
        const RoleMap roles = rolesByFamily(names, family);
        if (roles.count() > mapping.roles.count()) {
            mapping.roles = roles;
            mapping.family = family.name;
        }
    }
    if (!hasBothLegs(mapping.roles) || !hasBothArms(mapping.roles)) {
        const RoleMap shape = rolesByTopology(skeleton);
        constexpr int kTelling = 6;  // roles by name, below which the names say nothing
        if (mapping.roles.count() >= kTelling) {
            fillGaps(mapping.roles, shape);
        } else if (hasBothLegs(shape) && hasBothArms(shape)) {
            mapping.roles = shape;
            mapping.family = "topology";
            mapping.findings.push_back(warning(
                "The joint names say nothing; the roles were read off the skeleton's shape. "
                "Check left and right."));
        }
    }
    if (!hasBothLegs(mapping.roles) && !hasBothArms(mapping.roles)) {
        mapping = {};
        mapping.family = "none";
        mapping.findings.push_back(warning(
            "This skeleton is not a human body that is known here: it is shown and measured, but "
            "the contact force needs joint roles. Name them by hand if it is one."));
        return mapping;
    }
    completeFromTree(skeleton, mapping.roles, mapping.findings);
    reportMissing(mapping.roles, mapping.findings);
    return mapping;
}

}  // namespace kumite
