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
constexpr double kTurnRadius = 0.3;      ///< radius of a curved arrow
constexpr double kTurnPiece = 0.2;       ///< angle of a straight piece of it, radians
constexpr double kLeastTurn = 0.05;      ///< smaller turns are not shown, radians
constexpr std::uint32_t kSegments = 24;

/// The head of an arrow from the origin along +z.
TriangleMesh makeHead(double full) {
  TriangleMesh head;
  head.vertices = {{0.0, 0.0, kHeadLength * full}, Vector3::Zero()};
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / kSegments;
    head.vertices.emplace_back(kHeadRadius * full * std::cos(angle), kHeadRadius * full * std::sin(angle), 0.0);
    const std::uint32_t at = 2 + i;
    const std::uint32_t next = 2 + (i + 1) % kSegments;
    head.triangles.push_back({0, at, next});
    head.triangles.push_back({1, next, at});
  }
  return head;
}

/// A round bar from one point to another.
TriangleMesh makeBar(const Vector3& from, const Vector3& to, double radius) {
  const Pose X_WB{0.5 * (from + to), leastRotation(Vector3::UnitZ(), to - from)};
  return transformed(makeCylinder(radius, (to - from).norm(), kSegments), X_WB);
}

/// An arrow from the origin along +z.
TriangleMesh makeArrow(double length, double full) {
  const double shaft = length - kHeadLength * full;
  TriangleMesh arrow = makeBar(Vector3::Zero(), {0.0, 0.0, shaft}, kShaft * full);
  append(arrow, transformed(makeHead(full), Pose::translation({0.0, 0.0, shaft})));
  return arrow;
}

/// An arrow about +z, which begins on +x.
TriangleMesh makeTurnArrow(double angle, double full) {
  const double radius = kTurnRadius * full;
  const auto at = [radius](double turned) -> Vector3 {
    return {radius * std::cos(turned), radius * std::sin(turned), 0.0};
  };
  const double shaft = angle - kHeadLength / kTurnRadius;
  const int pieces = static_cast<int>(std::lround(shaft / kTurnPiece));
  TriangleMesh arrow;
  for (int i = 0; i < pieces; ++i) {
    append(arrow, makeBar(at(shaft * i / pieces), at(shaft * (i + 1) / pieces), kShaft * full));
  }
  const Vector3 along(-std::sin(shaft), std::cos(shaft), 0.0);
  append(arrow, transformed(makeHead(full), {at(shaft), leastRotation(Vector3::UnitZ(), along)}));
  return arrow;
}

/// A mark whose z axis is this direction. It shows through bodies.
osg::ref_ptr<osg::MatrixTransform> shownThrough(const TriangleMesh& mark, const Vector3& from, const Vector3& z_W,
                                                const ScenePalette& palette) {
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(makeFlatSurface(mark, palette.guidance));
  osg::StateSet* state = geode->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
  state->setRenderBinDetails(20, "RenderBin");
  const Pose X_WA{from, leastRotation(Vector3::UnitZ(), z_W)};
  osg::ref_ptr<osg::MatrixTransform> placed = new osg::MatrixTransform(toOsg(X_WA));
  placed->addChild(geode);
  return placed;
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
  return shownThrough(makeArrow(length, full), device.q_device.position, force_W, palette);
}

osg::ref_ptr<osg::Group> makeGuideArrow(const Pose& from, const Pose& to, const MarkScale& scale,
                                        const ScenePalette& palette) {
  const double full = scale.length(kRadiiAtFull, kMostOfView);
  const Vector3 way = to.position - from.position;
  const Vector3 turn = rotationVector(from.orientation, to.orientation);
  osg::ref_ptr<osg::Group> arrows = new osg::Group;
  if (way.norm() >= kHeadLength * full) {
    arrows->addChild(shownThrough(makeArrow(std::min(full, way.norm()), full), from.position, way, palette));
  }
  if (turn.norm() >= kLeastTurn) {
    const double shown = std::max(turn.norm(), kHeadLength / kTurnRadius);
    arrows->addChild(shownThrough(makeTurnArrow(shown, full), from.position, turn, palette));
  }
  return arrows;
}

osg::Vec4 guidanceTint(const osg::Vec4& objectColour, float strength, const ScenePalette& palette) {
  const float share = kStrongestTint * std::round(kTints * strength) / kTints;
  return objectColour * (1.0F - share) + palette.guidance * share;
}

}  // namespace glissade
