// The parts of the 3D view that need no window: picking, shadows, trails, where cameras stand.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>

#include "studio/view3d/camera_controller.h"
#include "studio/view3d/floor_shadow.h"
#include "studio/view3d/measuring.h"
#include "studio/view3d/picking.h"

namespace kumite::studio {
namespace {

constexpr Viewport kViewport{900, 600};
const Ray kAlongZ{{0, 0, 5}, {0, 0, -1}};

TEST(Picking, RayHitsACapsuleWhereItsSurfaceIs) {
    const auto hit = hitCapsule(kAlongZ, {-1, 0, 0}, {1, 0, 0}, 0.2, 0.2);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(*hit, 4.8, 1e-9);
}

TEST(Picking, CapsuleEndsAreRoundAndTapered) {
    EXPECT_TRUE(hitCapsule(kAlongZ, {0.19, 0, 0}, {2, 0, 0}, 0.2, 0.1));
    EXPECT_FALSE(hitCapsule(kAlongZ, {0.21, 0, 0}, {2, 0, 0}, 0.2, 0.1));
    EXPECT_TRUE(hitCapsule(kAlongZ, {0.21, 0, 0}, {2, 0, 0}, 0.2, 0.1, 0.02));
    // Half way the radius is 0.15.
    EXPECT_TRUE(hitCapsule(kAlongZ, {-1, 0.149, 0}, {1, 0.149, 0}, 0.2, 0.1));
    EXPECT_FALSE(hitCapsule(kAlongZ, {-1, 0.151, 0}, {1, 0.151, 0}, 0.2, 0.1));
}

TEST(Picking, NothingBehindTheCameraIsHit) {
    EXPECT_FALSE(hitCapsule(kAlongZ, {-1, 0, 8}, {1, 0, 8}, 0.2, 0.2));
}

TEST(Picking, CapsuleAlongTheRayAndPointlikeCapsule) {
    EXPECT_TRUE(hitCapsule(kAlongZ, {0.1, 0, 0}, {0.1, 0, -2}, 0.2, 0.2));
    EXPECT_FALSE(hitCapsule(kAlongZ, {0.3, 0, 0}, {0.3, 0, -2}, 0.2, 0.2));
    EXPECT_TRUE(hitCapsule(kAlongZ, {0, 0, 0}, {0, 0, 0}, 0.1, 0.1));
}

TEST(Picking, NearestBoneOfABodyCounts) {
    const std::vector<Eigen::Vector3f> joints = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 2}, {1, 0, 2}};
    const std::vector<Bone> bones = {{0, 1, 0.1, 0.1}, {2, 3, 0.1, 0.1}};
    EXPECT_NEAR(hitBody(kAlongZ, bones, joints).value_or(0), 2.9, 1e-6);
    EXPECT_NEAR(hitBody(kAlongZ, {bones[0]}, joints).value_or(0), 4.9, 1e-6);
    EXPECT_FALSE(hitBody({{0.5, 0.5, 5}, {0, 0, -1}}, bones, joints));
}

TEST(Picking, JointUnderThePointerAndOfTwoTheOneInFront) {
    CameraController camera;
    camera.standAt({0, 1, 5}, {0, 1, 0});
    const std::vector<Eigen::Vector3f> joints = {{0, 1, -1}, {0, 1, 1}, {0.5F, 1, 0}};
    EXPECT_EQ(jointNear(camera, kViewport, joints, 450, 300, 10)->joint, 1);
    const Eigen::Vector3d side = camera.project({0.5, 1, 0}, kViewport);
    EXPECT_EQ(jointNear(camera, kViewport, joints, side.x() + 4, side.y(), 10)->joint, 2);
    EXPECT_FALSE(jointNear(camera, kViewport, joints, 20, 20, 10));
}

TEST(CameraController, RayThroughAProjectedPointMeetsIt) {
    CameraController camera;
    const Eigen::Vector3d point(0.4, 1.3, -0.7);
    const Eigen::Vector3d at = camera.project(point, kViewport);
    const Ray ray = camera.rayThrough(at.x(), at.y(), kViewport);
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
    EXPECT_NEAR((point - ray.origin).cross(ray.direction).norm(), 0, 1e-9);
}

TEST(CameraController, StandsWhereItIsPut) {
    CameraController camera;
    const Eigen::Vector3d position(1, 2, -3);
    const Eigen::Vector3d target(-0.5, 1, 2);
    camera.standAt(position, target);
    EXPECT_NEAR((camera.position() - position).norm(), 0, 1e-9);
    EXPECT_NEAR((camera.target() - target).norm(), 0, 1e-9);
    EXPECT_NEAR(camera.up().dot(camera.forward()), 0, 1e-9);
}

int darkest(const FloorShadow& shadow) {
    return *std::max_element(shadow.darkness.begin(), shadow.darkness.end());
}

TEST(FloorShadow, IsDarkerAndSmallerUnderWhatTouchesTheFloor) {
    const std::vector<Bone> bones = {{0, 1, 0.05, 0.05}};
    FloorShadow low;
    FloorShadow high;
    castShadow(bones, {{0, 0.05F, 0}, {0.3F, 0.05F, 0}}, 0, low);
    castShadow(bones, {{0, 1.05F, 0}, {0.3F, 1.05F, 0}}, 0, high);
    EXPECT_GT(darkest(low), 2 * darkest(high));
    EXPECT_GT(darkest(high), 0);
    EXPECT_LT(low.extent, high.extent);
    EXPECT_NEAR(low.centre.x(), 0.15F, 1e-4);
}

TEST(FloorShadow, BorderIsEmpty) {
    FloorShadow shadow;
    castShadow({{0, 1, 0.1, 0.05}}, {{2, 0.5F, 1}, {2.4F, 0.1F, 1.5F}}, 0, shadow);
    constexpr int kCells = FloorShadow::kCells;
    for (int i = 0; i < kCells; ++i) {
        for (const int cell : {i, i * kCells, i * kCells + kCells - 1, (kCells - 1) * kCells + i})
            EXPECT_EQ(shadow.darkness[static_cast<std::size_t>(cell)], 0);
    }
}

TEST(FigureMesh, ThreadFollowsItsPathAlsoWhereItRests) {
    Mesh mesh;
    mesh.addThread({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {0.1F, 0.1F, 0.1F, 0.1F});
    ASSERT_FALSE(mesh.points.empty());
    for (const auto& point : mesh.points)
        EXPECT_TRUE(point.allFinite());
    for (const int corner : mesh.triangles)
        EXPECT_LT(corner, static_cast<int>(mesh.points.size()));
    mesh.clear();
    mesh.addThread({{0, 0, 0}}, {0.1F});
    EXPECT_TRUE(mesh.triangles.empty());
}

TEST(FigureMesh, FloorBandKeepsItsDistanceFromTheFoot) {
    Mesh mesh;
    mesh.addFloorBand({0, 0.1F, 0}, {0.2F, 0.02F, 0}, 0.05F, 0.01F, 0);
    for (const auto& point : mesh.points) {
        EXPECT_EQ(point.y(), 0);
        const float x = std::clamp(point.x(), 0.0F, 0.2F);
        const float away = std::hypot(point.x() - x, point.z());
        EXPECT_GT(away, 0.0499F);
        EXPECT_LT(away, 0.0601F);
    }
}

TEST(Measuring, TwoClicksMeasureAndAThirdBeginsAnew) {
    Measuring measuring;
    measuring.click(JointRef{0, 3});
    measuring.click(JointRef{0, 3});
    EXPECT_FALSE(measuring.to);
    measuring.click(JointRef{1, 5});
    EXPECT_EQ(measuring.to, (JointRef{1, 5}));
    measuring.click(JointRef{1, 2});
    EXPECT_EQ(measuring.from, (JointRef{1, 2}));
    EXPECT_FALSE(measuring.to);
    measuring.click(std::nullopt);
    EXPECT_FALSE(measuring.from);
}

}  // namespace
}  // namespace kumite::studio
