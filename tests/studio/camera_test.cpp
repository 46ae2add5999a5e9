#include <gtest/gtest.h>

#include <numbers>

#include "studio/view3d/camera_controller.h"
#include "studio/view3d/figure_mesh.h"

namespace kumite::studio {
namespace {

constexpr Viewport kViewport{900, 600};

TEST(CameraController, FramedBoxFillsThePictureAndStaysInside) {
    CameraController camera;
    Box box;
    box.add({-2, 0, -1});
    box.add({3, 1.8, 2});
    camera.frame(box, kViewport);
    double widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d point((corner & 1) ? 3 : -2, (corner & 2) ? 1.8 : 0,
                                    (corner & 4) ? 2 : -1);
        const Eigen::Vector3d at = camera.project(point, kViewport);
        EXPECT_GT(at.x(), 0);
        EXPECT_LT(at.x(), kViewport.width);
        EXPECT_GT(at.y(), 0);
        EXPECT_LT(at.y(), kViewport.height);
        widest = std::max(widest, std::abs(at.x() - kViewport.width / 2));
    }
    EXPECT_GT(widest, 0.35 * kViewport.width);
}

TEST(CameraController, ZoomKeepsThePointUnderThePointer) {
    CameraController camera;
    const Eigen::Vector3d point = camera.target() + 0.6 * camera.right() - 0.3 * camera.up();
    const Eigen::Vector3d before = camera.project(point, kViewport);
    camera.zoomAbout(before.x(), before.y(), 1.7, kViewport);
    const Eigen::Vector3d after = camera.project(point, kViewport);
    EXPECT_NEAR(after.x(), before.x(), 1e-6);
    EXPECT_NEAR(after.y(), before.y(), 1e-6);
}

TEST(CameraController, PanFollowsThePointer) {
    CameraController camera;
    const Eigen::Vector3d point = camera.target();
    camera.pan(40, -25, kViewport);
    const Eigen::Vector3d after = camera.project(point, kViewport);
    EXPECT_NEAR(after.x(), kViewport.width / 2 + 40, 1e-6);
    EXPECT_NEAR(after.y(), kViewport.height / 2 - 25, 1e-6);
}

TEST(CameraController, OrbitKeepsTargetAndNeverTurnsOver) {
    CameraController camera;
    const double distance = camera.distance();
    camera.orbit(123, 5000, kViewport);
    EXPECT_NEAR((camera.position() - camera.target()).norm(), distance, 1e-9);
    EXPECT_GT(camera.up().dot(camera.up()), 0.99);
    EXPECT_LE(camera.forward().y(), -0.99);
}

TEST(CameraController, LooksFromTheFrontAndFromAbove) {
    CameraController camera;
    camera.lookFrom(0, 0);
    EXPECT_NEAR(camera.forward().z(), -1, 1e-9);
    camera.lookFrom(0, std::numbers::pi / 2);
    EXPECT_NEAR(camera.forward().y(), -1, 1e-5);
}

TEST(FigureMesh, SkeletonWithoutRolesHasABonePerJoint) {
    Skeleton skeleton;
    skeleton.joints.resize(4);
    for (int joint = 1; joint < 4; ++joint) {
        skeleton.joints[static_cast<std::size_t>(joint)].parent = joint - 1;
        skeleton.joints[static_cast<std::size_t>(joint)].offset = {0, 30, 0};
    }
    const auto bones = bonesOf(skeleton, {}, 0.01);
    ASSERT_EQ(bones.size(), 3U);
    for (const Bone& bone : bones)
        EXPECT_GT(bone.fromRadius, 0.005);
}

TEST(FigureMesh, CapsuleEnclosesItsEndsAndNormalsAreUnit) {
    Mesh mesh;
    mesh.addCapsule({0, 0, 0}, {0, 1, 0}, 0.2F, 0.1F);
    float low = 1;
    float high = 0;
    for (const auto& point : mesh.points) {
        low = std::min(low, point.y());
        high = std::max(high, point.y());
        EXPECT_LE(std::hypot(point.x(), point.z()), 0.2F + 1e-5F);
    }
    EXPECT_NEAR(low, -0.2F, 1e-5);
    EXPECT_NEAR(high, 1.1F, 1e-5);
    for (const auto& normal : mesh.normals)
        EXPECT_NEAR(normal.norm(), 1.0F, 1e-4);
    for (const int corner : mesh.triangles) {
        EXPECT_LT(corner, static_cast<int>(mesh.points.size()));
    }
}

TEST(FigureMesh, BoneOfNoLengthIsStillFinite) {
    Mesh mesh;
    mesh.addCapsule({1, 1, 1}, {1, 1, 1}, 0.1F, 0.1F);
    for (const auto& point : mesh.points)
        EXPECT_TRUE(point.allFinite());
}

}  // namespace
}  // namespace kumite::studio
