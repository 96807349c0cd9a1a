#include "widgets/scene3d/section_drag.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"
#include "widgets/scene3d/section_caps.h"

namespace glissade {
namespace {

const Box3 kDragBox(Vector3::Constant(-1.0), Vector3::Constant(1.0));

Ray rayTo(const CameraController& camera, const Vector3& p_W) {
  const Eigen::Vector2d seen = *camera.project(p_W);
  return rayThrough(camera, seen.x(), seen.y());
}

TEST(SectionDrag, WhatIsGrippedStaysUnderThePointer) {
  for (const bool otherSide : {false, true}) {
    CameraController camera;
    camera.fit(kDragBox);
    camera.lookFrom({1.0, -2.0, 1.5});
    const SectionPlane section{Vector3(0.3, 1.0, 0.2).normalized(), 0.2, otherSide, true};
    const SectionHandle handle = handleOf(section, kDragBox);
    ASSERT_FALSE(isKnob(handle, camera));
    const Vector3 tip = tipOf(handle, camera, 0.08);
    SectionDrag drag(section, handle, camera, rayTo(camera, tip));
    drag.moveTo(rayTo(camera, tip + 0.35 * section.direction));
    EXPECT_NEAR(drag.place(), 0.55, 1e-9);
  }
}

TEST(SectionDrag, AKnobGoesAwayFromTheEyeWithThePointerMovedUp) {
  for (const Vector3& direction : {Vector3(0.0, 1.0, 0.0), Vector3(0.0, -1.0, 0.0)}) {
    CameraController camera;
    camera.setStandardView(StandardView::Front);
    camera.fit(kDragBox);
    const SectionPlane section{direction, 0.0, false, true};
    const SectionHandle handle = handleOf(section, kDragBox);
    ASSERT_TRUE(isKnob(handle, camera));
    SectionDrag drag(section, handle, camera, rayTo(camera, handle.middle));
    drag.moveTo(rayTo(camera, handle.middle + 0.25 * Vector3::UnitZ()));
    const Vector3 moved = (drag.place() - section.place) * direction;
    EXPECT_NEAR(moved.norm(), 0.25, 1e-9);
    EXPECT_LT(moved.dot(camera.eye() - handle.middle), 0.0);
  }
}

TEST(SectionCaps, LargeBodiesAreLeftForAnotherThread) {
  const auto small = std::make_shared<const TriangleMesh>(makeBox({1.0, 1.0, 1.0}));
  const auto large = std::make_shared<const TriangleMesh>(makeCylinder(1.0, 1.0, 30'000));
  const std::vector<Plane> sections{{Vector3::UnitX(), 0.1}};
  const std::vector<CapBody> bodies{{small, Pose::identity(), {1, 0, 0, 1}},
                                    {large, Pose::translation({5.0, 0.0, 0.0}), {1, 0, 0, 1}}};
  const ScenePalette palette = paletteOf(Theme::Light);
  SectionCaps caps;
  caps.show(sections, bodies, palette);
  EXPECT_FALSE(caps.hasLeft()) << "the section does not meet the large one";
  caps.show({{Vector3::UnitZ(), 0.1}}, bodies, palette);
  ASSERT_TRUE(caps.hasLeft());
  const auto deliver = caps.work()(WorkWatch());
  EXPECT_TRUE(caps.hasLeft()) << "nothing is shown before it is delivered";
  deliver();
  EXPECT_FALSE(caps.hasLeft());
  // Caps stay valid while body and section do not move relative to each other.
  caps.show({{Vector3::UnitZ(), 0.1}}, bodies, palette);
  EXPECT_FALSE(caps.hasLeft());
  caps.show({{Vector3::UnitZ(), 0.2}}, bodies, palette);
  const auto late = caps.work()(WorkWatch());
  caps.show({{Vector3::UnitZ(), 0.3}}, bodies, palette);
  late();
  EXPECT_TRUE(caps.hasLeft()) << "what was moved meanwhile is made again";
}

}  // namespace
}  // namespace glissade
