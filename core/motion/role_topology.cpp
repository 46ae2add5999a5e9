#include "core/motion/role_topology.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace kumite {
namespace {

using enum Role;

/// A chain of joints that may be a limb: from a child of a branching joint to the farthest end.
struct Chain {
    std::vector<int> joints;
    double length = 0;  ///< of its bones, without the one that leads to it
};

/// A chain and its mirror image at the same branching joint.
struct ChainPair {
    int branch = 0;
    int depth = 0;
    Chain first;
    Chain second;
};

struct Tree {
    const Skeleton& skeleton;
    std::vector<std::vector<int>> children;
    std::vector<Eigen::Vector3d> rest;
    std::vector<Chain> longest;  ///< per joint, the longest chain that starts there
    std::vector<int> depth;

    explicit Tree(const Skeleton& s)
        : skeleton(s),
          children(s.joints.size()),
          rest(s.restPositions()),
          longest(s.joints.size()),
          depth(s.joints.size(), 0) {
        for (std::size_t i = 1; i < s.joints.size(); ++i) {
            const auto parent = static_cast<std::size_t>(s.joints[i].parent);
            children[parent].push_back(static_cast<int>(i));
            depth[i] = depth[parent] + 1;
        }
        for (std::size_t i = s.joints.size(); i-- > 0;) {
            Chain best;
            for (const int child : children[i]) {
                const Chain& below = longest[static_cast<std::size_t>(child)];
                const double length = below.length + boneTo(child);
                if (best.joints.empty() || length > best.length) best = {below.joints, length};
            }
            best.joints.insert(best.joints.begin(), static_cast<int>(i));
            longest[i] = std::move(best);
        }
    }

    double boneTo(int joint) const {
        return skeleton.joints[static_cast<std::size_t>(joint)].offset.norm();
    }
};

bool similar(double a, double b) {
    return std::abs(a - b) <= 0.1 * std::max(a, b);
}

/// Mirror images: as many joints, and every bone as long as its twin. Shorter than two bones is no
/// limb.
bool areTwins(const Tree& tree, const Chain& a, const Chain& b) {
    if (a.joints.size() != b.joints.size() || a.joints.size() < 3) return false;
    for (std::size_t i = 0; i < a.joints.size(); ++i) {
        if (!similar(tree.boneTo(a.joints[i]), tree.boneTo(b.joints[i]))) return false;
    }
    return true;
}

std::vector<ChainPair> findPairs(const Tree& tree) {
    std::vector<ChainPair> pairs;
    for (std::size_t i = 0; i < tree.children.size(); ++i) {
        const std::vector<int>& children = tree.children[i];
        for (std::size_t a = 0; a < children.size(); ++a) {
            for (std::size_t b = a + 1; b < children.size(); ++b) {
                const Chain& first = tree.longest[static_cast<std::size_t>(children[a])];
                const Chain& second = tree.longest[static_cast<std::size_t>(children[b])];
                if (!areTwins(tree, first, second)) continue;
                pairs.push_back({static_cast<int>(i), tree.depth[i], first, second});
            }
        }
    }
    return pairs;
}

/// Index in the chain of the joint where the first of its two long neighbouring bones begins:
/// thigh and shank, or upper arm and forearm.
std::optional<std::size_t> longBones(const Tree& tree, const Chain& chain) {
    std::optional<std::size_t> best;
    double most = 0;
    for (std::size_t i = 0; i + 2 < chain.joints.size(); ++i) {
        const double sum = tree.boneTo(chain.joints[i + 1]) + tree.boneTo(chain.joints[i + 2]);
        if (sum > most) {
            most = sum;
            best = i;
        }
    }
    return best;
}

void setLeg(const Tree& tree, const Chain& chain, bool left, RoleMap& roles) {
    const auto at = longBones(tree, chain);
    if (!at) return;
    const auto side = [left](Role role) { return left ? role : mirrored(role); };
    roles.set(side(LeftHip), chain.joints[*at]);
    roles.set(side(LeftKnee), chain.joints[*at + 1]);
    roles.set(side(LeftAnkle), chain.joints[*at + 2]);
    if (*at + 3 < chain.joints.size()) roles.set(side(LeftToe), chain.joints[*at + 3]);
}

void setArm(const Tree& tree, const Chain& chain, bool left, RoleMap& roles) {
    const auto at = longBones(tree, chain);
    if (!at) return;
    const auto side = [left](Role role) { return left ? role : mirrored(role); };
    if (*at > 0) roles.set(side(LeftClavicle), chain.joints[*at - 1]);
    roles.set(side(LeftShoulder), chain.joints[*at]);
    roles.set(side(LeftElbow), chain.joints[*at + 1]);
    roles.set(side(LeftWrist), chain.joints[*at + 2]);
}

/// The direction of the left side at rest: up × forward, where forward is where the feet point
/// (without feet, +z, or −y where z is up).
Eigen::Vector3d leftward(const Tree& tree, const ChainPair& legs) {
    const auto restOf = [&](int joint) { return tree.rest[static_cast<std::size_t>(joint)]; };
    const Eigen::Vector3d leg =
        restOf(legs.first.joints.front()) - restOf(legs.first.joints.back());
    const bool zUp = std::abs(leg.z()) > std::abs(leg.y());
    const Eigen::Vector3d up = zUp ? Eigen::Vector3d(0, 0, 1) : Eigen::Vector3d(0, 1, 0);
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();
    for (const Chain* chain : {&legs.first, &legs.second}) {
        const auto at = longBones(tree, *chain);
        if (at && *at + 3 < chain->joints.size()) {
            forward += restOf(chain->joints.back()) - restOf(chain->joints[*at + 2]);
        }
    }
    forward -= forward.dot(up) * up;
    if (forward.norm() < 1e-9) {
        forward = zUp ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
    }
    return up.cross(forward);
}

}  // namespace

int commonAncestor(const Skeleton& skeleton, int a, int b) {
    while (a != b) {
        int& deeper = a > b ? a : b;  // parents stand before their children
        deeper = skeleton.joints[static_cast<std::size_t>(deeper)].parent;
        if (deeper < 0) return 0;
    }
    return a;
}

std::vector<int> pathDown(const Skeleton& skeleton, int ancestor, int joint) {
    std::vector<int> path;
    for (; joint > ancestor; joint = skeleton.joints[static_cast<std::size_t>(joint)].parent) {
        path.push_back(joint);
    }
    if (joint != ancestor) return {};
    std::reverse(path.begin(), path.end());
    return path;
}

std::optional<int> endSiteOf(const Skeleton& skeleton, int joint) {
    for (const int child : skeleton.childrenOf(joint)) {
        if (skeleton.joints[static_cast<std::size_t>(child)].isEndSite) return child;
    }
    return std::nullopt;
}

RoleMap rolesByTopology(const Skeleton& skeleton) {
    RoleMap roles;
    const Tree tree(skeleton);
    std::vector<ChainPair> pairs = findPairs(tree);
    // Limbs are the longest pairs; fingers and eyes are shorter.
    std::stable_sort(pairs.begin(), pairs.end(), [](const ChainPair& a, const ChainPair& b) {
        return a.first.length > b.first.length;
    });
    if (pairs.size() < 2) return roles;
    const ChainPair* legs = pairs.data();
    const ChainPair* arms = nullptr;
    for (std::size_t i = 1; i < pairs.size() && !arms; ++i) {
        if (pairs[i].branch != legs->branch) arms = &pairs[i];
    }
    if (!arms) return roles;
    if (arms->depth < legs->depth) std::swap(legs, arms);

    const Eigen::Vector3d left = leftward(tree, *legs);
    const auto isLeft = [&](const Chain& a, const Chain& b) {
        const auto middle = [&](const Chain& chain) {
            return tree.rest[static_cast<std::size_t>(chain.joints[chain.joints.size() / 2])];
        };
        return (middle(a) - middle(b)).dot(left) > 0;
    };
    roles.set(Pelvis, legs->branch);
    const bool legsInOrder = isLeft(legs->first, legs->second);
    setLeg(tree, legs->first, legsInOrder, roles);
    setLeg(tree, legs->second, !legsInOrder, roles);
    const bool armsInOrder = isLeft(arms->first, arms->second);
    setArm(tree, arms->first, armsInOrder, roles);
    setArm(tree, arms->second, !armsInOrder, roles);

    // The head is what else grows where the arms do: neck first, then head.
    const Chain* head = nullptr;
    for (const int child : tree.children[static_cast<std::size_t>(arms->branch)]) {
        const Chain& chain = tree.longest[static_cast<std::size_t>(child)];
        if (child == arms->first.joints.front() || child == arms->second.joints.front()) continue;
        if (!head || chain.length > head->length) head = &chain;
    }
    if (head) {
        roles.set(Neck, head->joints.front());
        if (head->joints.size() > 1) roles.set(Head, head->joints[1]);
    }
    return roles;
}

}  // namespace kumite
