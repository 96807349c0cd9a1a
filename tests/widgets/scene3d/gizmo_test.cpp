#include "widgets/scene3d/gizmo_drag.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

using Kind = GizmoHandle::Kind;

constexpr double kArm = 0.12;
constexpr double kMargin = 0.012;

/// A camera at a random pose that looks near the origin, and a gizmo in its view.
struct Sight {
  CameraController camera;
  Gizmo gizmo;

  explicit Sight(RandomStream& random) {
    camera.setOrthographic(random.uniform() < 0.5);
    camera.fit(Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0)));
    camera.lookFrom({random.normal(), random.normal(), random.normal()});
    camera.zoom(random.uniform(0.5, 2.0), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
    gizmo = gizmoAt(randomPose(random, 0.3), camera, kArm);
  }

  Ray rayAt(const Eigen::Vector2d& p) const { return rayThrough(camera, p.x(), p.y()); }
  Eigen::Vector2d seen(const Vector3& p_W) const { return *camera.project(p_W); }
  /// A point of the handle in the world at which the pointer can grip it.
  std::optional<Vector3> grip(const GizmoHandle& handle, RandomStream& random) const {
    const std::vector<Vector3> outline = outlineOf(handle, gizmo);
    if (!isUsable(handle, gizmo, camera)) return std::nullopt;
    if (handle.kind == Kind::Arrow) return outline[0] + random.uniform(0.3, 0.9) * (outline[1] - outline[0]);
    if (handle.kind == Kind::Square) return 0.5 * (outline[0] + outline[2]);
    const Vector3& p_W = outline[static_cast<std::size_t>(random.uniform() * 72.0)];
    return isBeforeCentre(p_W, gizmo, camera) ? std::optional(p_W) : std::nullopt;
  }
};

TEST(Gizmo, HasOneSizeOnTheScreen) {
  RandomStream random(3, "gizmo size");
  for (int i = 0; i < 100; ++i) {
    const Sight sight(random);
    const Vector3 centre = sight.gizmo.X_WG.position;
    const Vector3 right = sight.camera.R_WV() * Vector3::UnitX();
    EXPECT_NEAR((sight.seen(centre + sight.gizmo.arm * right) - sight.seen(centre)).norm(), kArm, 1e-9);
  }
}

TEST(Gizmo, TheHandleUnderThePointerIsMeant) {
  RandomStream random(5, "gizmo hit");
  int arrows = 0;
  int hits = 0;
  int tries = 0;
  for (int i = 0; i < 300; ++i) {
    const Sight sight(random);
    for (const GizmoHandle& handle : kGizmoHandles) {
      const auto at = sight.grip(handle, random);
      if (!at) continue;
      const auto hit = handleAt(sight.gizmo, sight.camera, sight.seen(*at), kMargin);
      ASSERT_TRUE(hit) << "something is there";
      ++tries;
      hits += *hit == handle ? 1 : 0;
      if (handle.kind != Kind::Arrow) continue;
      ++arrows;
      EXPECT_NE(hit->kind, Kind::Square) << "a square that is crossed by an arrow";
    }
    EXPECT_FALSE(handleAt(sight.gizmo, sight.camera,
                          sight.seen(sight.gizmo.X_WG.position) + Eigen::Vector2d(2.0 * kArm, 0.0), kMargin));
  }
  EXPECT_GT(arrows, 500);
  EXPECT_GT(hits, 0.85 * tries) << "handles may cross on the screen, but seldom";
}

TEST(Gizmo, AnArrowThatPointsAtTheEyeAndASquareSeenFromItsEdgeAreNotTaken) {
  Sight sight = [] {
    RandomStream random(1, "eye");
    return Sight(random);
  }();
  sight.camera.lookFrom(Vector3::UnitZ());
  sight.camera.setOrthographic(true);
  sight.gizmo = gizmoAt(Pose::identity(), sight.camera, kArm);
  EXPECT_FALSE(isUsable({Kind::Arrow, 2}, sight.gizmo, sight.camera));
  EXPECT_TRUE(isUsable({Kind::Arrow, 0}, sight.gizmo, sight.camera));
  EXPECT_FALSE(isUsable({Kind::Square, 0}, sight.gizmo, sight.camera));
  EXPECT_TRUE(isUsable({Kind::Square, 2}, sight.gizmo, sight.camera));
}

TEST(GizmoDrag, AnArrowMovesAlongItsAxisOnlyAndStaysUnderThePointer) {
  RandomStream random(9, "gizmo arrow");
  int tries = 0;
  for (int i = 0; i < 300; ++i) {
    const Sight sight(random);
    const GizmoHandle handle{Kind::Arrow, i % 3};
    const auto from = sight.grip(handle, random);
    if (!from) continue;
    ++tries;
    GizmoDrag drag(handle, sight.gizmo, sight.rayAt(sight.seen(*from)));
    const Vector3 along = axisOf(sight.gizmo, handle.axis);
    const double by = random.uniform(-0.5, 0.5);
    drag.moveTo(sight.rayAt(sight.seen(*from + by * along)));
    EXPECT_NEAR(drag.amount().shift[handle.axis], by, 1e-9);
    // A pointer anywhere moves the item along the axis only.
    drag.moveTo(sight.rayAt({random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)}));
    const Pose motion = motionOf(drag.amount(), handle.axis, sight.gizmo.X_WG);
    EXPECT_LT(motion.position.cross(along).norm(), 1e-12);
    EXPECT_EQ(angleBetween(motion.orientation, Quaternion::Identity()), 0.0);
  }
  EXPECT_GT(tries, 200);
}

TEST(GizmoDrag, ASquareMovesAcrossItsAxisAndStaysUnderThePointer) {
  RandomStream random(13, "gizmo square");
  int tries = 0;
  for (int i = 0; i < 300; ++i) {
    const Sight sight(random);
    const GizmoHandle handle{Kind::Square, i % 3};
    const auto from = sight.grip(handle, random);
    if (!from) continue;
    ++tries;
    GizmoDrag drag(handle, sight.gizmo, sight.rayAt(sight.seen(*from)));
    const Eigen::Vector2d to = sight.seen(*from) + Eigen::Vector2d(random.uniform(-0.1, 0.1), 0.05);
    drag.moveTo(sight.rayAt(to));
    const Pose motion = motionOf(drag.amount(), handle.axis, sight.gizmo.X_WG);
    EXPECT_EQ(drag.amount().shift[handle.axis], 0.0);
    EXPECT_NEAR(motion.position.dot(axisOf(sight.gizmo, handle.axis)), 0.0, 1e-12);
    const auto now = sight.camera.project(motion * *from);
    ASSERT_TRUE(now);
    if (drag.amount().shift.isZero(0.0)) continue;  // the ray does not meet the plane
    EXPECT_LT((*now - to).norm(), 1e-9);
  }
  EXPECT_GT(tries, 200);
}

TEST(GizmoDrag, ARingTurnsByTheAngleSeen) {
  RandomStream random(17, "gizmo ring");
  int tries = 0;
  for (int i = 0; i < 300; ++i) {
    const Sight sight(random);
    const GizmoHandle handle{Kind::Ring, i % 3};
    const Vector3 about = axisOf(sight.gizmo, handle.axis);
    const Vector3& centre = sight.gizmo.X_WG.position;
    const auto from = sight.grip(handle, random);
    const Ray grip = from ? sight.rayAt(sight.seen(*from)) : Ray{};
    if (!from || std::abs(about.dot(grip.direction)) < 0.3) continue;
    ++tries;
    GizmoDrag drag(handle, sight.gizmo, grip);
    const double angle = random.uniform(-3.0, 3.0);
    for (int step = 1; step <= 10; ++step) {
      const Quaternion turn(Eigen::AngleAxisd(0.1 * step * angle, about));
      drag.moveTo(sight.rayAt(sight.seen(centre + turn * (*from - centre))));
    }
    EXPECT_NEAR(drag.amount().angle, angle, 1e-6);
    const Pose motion = motionOf(drag.amount(), handle.axis, sight.gizmo.X_WG);
    EXPECT_LT((motion * centre - centre).norm(), 1e-12) << "it turns in place";
    EXPECT_LT((motion.orientation * about - about).norm(), 1e-9);
  }
  EXPECT_GT(tries, 80);
}

TEST(GizmoDrag, ARingGoesOnBeyondATurn) {
  CameraController camera;
  camera.fit(Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0)));
  camera.lookFrom(Vector3(0.3, -0.2, 1.0));
  const Gizmo gizmo = gizmoAt(Pose::identity(), camera, kArm);
  const auto rayAt = [&](double angle) {
    const auto at = camera.project(ringRadius(gizmo) * Vector3(std::cos(angle), std::sin(angle), 0.0));
    return rayThrough(camera, at->x(), at->y());
  };
  GizmoDrag drag({Kind::Ring, 2}, gizmo, rayAt(0.0));
  for (double angle = 0.0; angle < 9.0; angle += 0.25) drag.moveTo(rayAt(angle));
  EXPECT_NEAR(drag.amount().angle, 8.75, 1e-6);
}

TEST(GizmoDrag, ARingSeenFromItsEdgeFollowsThePointerAlongIt) {
  CameraController camera;
  camera.setOrthographic(true);
  camera.fit(Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0)));
  camera.lookFrom(-Vector3::UnitY());  // x to the right, z upwards
  const Gizmo gizmo = gizmoAt(Pose::identity(), camera, kArm);
  GizmoDrag drag({Kind::Ring, 2}, gizmo, rayThrough(camera, 0.0, 0.0));
  drag.moveTo(rayThrough(camera, 0.05, 0.2));
  EXPECT_NEAR(drag.amount().angle, 0.05 * camera.viewHeight() / ringRadius(gizmo), 1e-9);
  // The front moves to the right, as the pointer does.
  const Pose motion = motionOf(drag.amount(), 2, gizmo.X_WG);
  EXPECT_GT((motion * Vector3(0, -1, 0)).x(), 0.0);
}

TEST(GizmoDrag, SnapsToWholeSteps) {
  const GizmoSteps steps{0.01, std::numbers::pi / 12.0};
  const GizmoAmount amount = snapped({Vector3(0.0149, -0.026, 0.0), 0.3}, steps);
  EXPECT_LT((amount.shift - Vector3(0.01, -0.03, 0.0)).norm(), 1e-15);
  EXPECT_NEAR(amount.angle, std::numbers::pi / 12.0, 1e-15);
  EXPECT_EQ(snapped({Vector3(0.0149, 0, 0), 0.3}, {0.0, 0.0}).shift.x(), 0.0149) << "no step";
}

}  // namespace
}  // namespace glissade
