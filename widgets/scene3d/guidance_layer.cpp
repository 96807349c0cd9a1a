#include "widgets/scene3d/guidance_layer.h"

#include <osg/Depth>

#include <algorithm>
#include <cmath>

#include "engine/geometry/least_rotation.h"
#include "engine/geometry/primitives.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr double kLeastForceShown = 0.01;  ///< weaker forces are not shown
constexpr double kRadiiAtFull = 2.0;       ///< length of the arrow at full strength, radii of the object
constexpr double kMostOfView = 0.20;       ///< largest length at full strength, shares of the view's height
constexpr double kWeakest = 0.15;          ///< share of the full length that weak forces have, to show their direction
constexpr double kShaft = 0.017;           ///< this and the following are shares of the full length
constexpr double kHeadRadius = 0.05;
constexpr double kHeadLength = 0.12;
constexpr float kStrongestTint = 0.75F;  ///< share that keeps the object's own colour recognisable
constexpr float kTints = 32.0F;          ///< number of tints: each new one is uploaded with the surface
constexpr std::uint32_t kSegments = 24;

/// An arrow from the origin along +z.
TriangleMesh makeArrow(double length, double full) {
  const double shaft = length - kHeadLength * full;
  TriangleMesh arrow =
      transformed(makeCylinder(kShaft * full, shaft, kSegments), Pose::translation({0.0, 0.0, 0.5 * shaft}));
  TriangleMesh head;
  head.vertices = {{0.0, 0.0, length}, {0.0, 0.0, shaft}};
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / kSegments;
    head.vertices.emplace_back(kHeadRadius * full * std::cos(angle), kHeadRadius * full * std::sin(angle), shaft);
    const std::uint32_t at = 2 + i;
    const std::uint32_t next = 2 + (i + 1) % kSegments;
    head.triangles.push_back({0, at, next});
    head.triangles.push_back({1, next, at});
  }
  append(arrow, head);
  return arrow;
}

/// An arrow that shows through bodies.
osg::ref_ptr<osg::MatrixTransform> arrowAlong(const Vector3& from, const Vector3& way, double full,
                                              const ScenePalette& palette) {
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(makeFlatSurface(makeArrow(way.norm(), full), palette.guidance));
  osg::StateSet* state = geode->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
  state->setRenderBinDetails(20, "RenderBin");
  const Pose X_WA{from, leastRotation(Vector3::UnitZ(), way)};
  osg::ref_ptr<osg::MatrixTransform> arrow = new osg::MatrixTransform(toOsg(X_WA));
  arrow->addChild(geode);
  return arrow;
}

}  // namespace

float guidanceStrength(const Wrench& guidance) {
  return static_cast<float>(std::min(1.0, std::max(guidance.force_W.norm(), guidance.torque_W.norm())));
}

osg::ref_ptr<osg::MatrixTransform> makeGuidance(const OperatorSample& device, const MarkScale& scale,
                                                const ScenePalette& palette) {
  const Vector3& force_W = device.guidance.force_W;
  const double strength = force_W.norm();
  if (strength < kLeastForceShown) return nullptr;
  const double full = scale.length(kRadiiAtFull, kMostOfView);
  const double length = std::clamp(strength, kWeakest, 1.0) * full;
  return arrowAlong(device.q_device.position, length / strength * force_W, full, palette);
}

osg::ref_ptr<osg::MatrixTransform> makeGuideArrow(const Vector3& from, const Vector3& to, const MarkScale& scale,
                                                  const ScenePalette& palette) {
  const Vector3 way = to - from;
  const double full = scale.length(kRadiiAtFull, kMostOfView);
  if (way.norm() < kHeadLength * full) return nullptr;
  return arrowAlong(from, std::min(1.0, full / way.norm()) * way, full, palette);
}

osg::Vec4 guidanceTint(const osg::Vec4& objectColour, float strength, const ScenePalette& palette) {
  const float share = kStrongestTint * std::round(kTints * strength) / kTints;
  return objectColour * (1.0F - share) + palette.guidance * share;
}

}  // namespace glissade
