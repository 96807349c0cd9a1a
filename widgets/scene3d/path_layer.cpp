#include "widgets/scene3d/path_layer.h"

#include <osg/CullFace>
#include <osg/Depth>
#include <osg/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/geometry/pose.h"
#include "engine/geometry/primitives.h"
#include "widgets/controls/author_colour.h"
#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {
namespace {

/// A point of a tube, with its colour there.
struct TubePoint {
  Vector3 p_W;
  osg::Vec4 colour;
};

constexpr int kSides = 8;

/// The mean directions of the segments before and after each point.
std::vector<Vector3> tangentsOf(const std::vector<TubePoint>& points) {
  std::vector<Vector3> tangents(points.size(), Vector3::Zero());
  Vector3 before = Vector3::Zero();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector3 way = points[i].p_W - points[i - 1].p_W;
    if (way.norm() > 0.0) before = way.normalized();
    tangents[i] += before;
  }
  Vector3 after = Vector3::Zero();
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    const Vector3 way = points[i + 1].p_W - points[i].p_W;
    if (way.norm() > 0.0) after = way.normalized();
    tangents[i] += after;
  }
  return tangents;
}

/// Adds one ring about a point.
void addRing(const TubePoint& point, const Vector3& u, const Vector3& v, double radius, osg::Vec3Array& corners,
             osg::Vec3Array& normals, osg::Vec4Array& colours) {
  for (int side = 0; side < kSides; ++side) {
    const double angle = 2.0 * std::numbers::pi * side / kSides;
    const Vector3 normal = std::cos(angle) * u + std::sin(angle) * v;
    corners.push_back(toOsg(Vector3(point.p_W + radius * normal)));
    normals.push_back(toOsg(normal));
    colours.push_back(point.colour);
  }
}

/// Triangles between successive rings.
osg::ref_ptr<osg::DrawElementsUInt> joinRings(std::size_t rings) {
  osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
  for (unsigned ring = 0; ring + 1 < rings; ++ring) {
    for (unsigned side = 0; side < kSides; ++side) {
      const unsigned a = ring * kSides + side;
      const unsigned b = ring * kSides + (side + 1) % kSides;
      for (const unsigned corner : {a, b, b + kSides, a, b + kSides, a + kSides}) triangles->push_back(corner);
    }
  }
  return triangles;
}

/// A lit tube along the points; its colours run from one point to the next. Successive equal points change the colour
/// at once.
osg::ref_ptr<osg::Geometry> makeTube(const std::vector<TubePoint>& points, double radius) {
  osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
  const std::vector<Vector3> tangents = tangentsOf(points);
  Vector3 u = Vector3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 tangent = tangents[i].norm() > 0.0 ? Vector3(tangents[i].normalized()) : Vector3::UnitZ();
    // The rings turn as little as possible, so that the tube is not twisted.
    u -= u.dot(tangent) * tangent;
    u = u.norm() > 1e-6 ? Vector3(u.normalized()) : tangent.unitOrthogonal();
    addRing(points[i], u, tangent.cross(u), radius, *corners, *normals, *colours);
  }
  osg::ref_ptr<osg::Geometry> tube = new osg::Geometry;
  tube->setVertexArray(corners);
  tube->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
  tube->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
  tube->addPrimitiveSet(joinRings(points.size()));
  tube->setUseVertexBufferObjects(true);
  return tube;
}

constexpr float kPathWidth = 4.0F;
/// A dark rim keeps the path legible before bodies of any colour.
constexpr float kRimWidth = 7.0F;
constexpr float kRimOpacity = 0.55F;
/// Number and opacity of the object's ghosts where a path is blocked.
constexpr std::size_t kBlockedGhosts = 7;
constexpr float kFaded = 0.45F;
/// Radius of the ball at the tightest place, in radii of the tube.
constexpr double kTightestBall = 2.5;

/// The share of each sample between the tightest place and the widest, by the logarithm of its clearance.
std::vector<double> sharesOf(const ClearanceProfile& profile) {
  const auto [least, most] =
      std::minmax_element(profile.samples.begin(), profile.samples.end(),
                          [](const auto& a, const auto& b) { return a.nearest.distance < b.nearest.distance; });
  constexpr double kSmallest = 1e-9;  // metres: logarithms need more than 0
  const double low = std::log(std::max(kSmallest, least->nearest.distance));
  const double range = std::log(std::max(kSmallest, most->nearest.distance)) - low;
  std::vector<double> shares;
  for (const ClearanceSample& sample : profile.samples) {
    shares.push_back(range > 0.0 ? (std::log(std::max(kSmallest, sample.nearest.distance)) - low) / range : 1.0);
  }
  return shares;
}

std::vector<TubePoint> pointsByClearance(const ClearanceProfile& profile) {
  const std::vector<double> shares = sharesOf(profile);
  std::vector<TubePoint> points;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    points.push_back({profile.samples[i].q.position, clearanceColour(shares[i])});
  }
  return points;
}

void addByClearance(const ClearanceProfile& profile, float width, osg::Geode& geode) {
  const std::vector<TubePoint> points = pointsByClearance(profile);
  std::vector<Vector3> way;
  for (const TubePoint& point : points) way.push_back(point.p_W);
  const auto make = [&](float opacity) {
    osg::ref_ptr<osg::Geometry> line = makeLines(way, LineKind::Strip, {}, width);
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    for (const auto& [p_W, colour] : points) colours->push_back({colour.r(), colour.g(), colour.b(), opacity});
    line->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    return line;
  };
  addSeenThrough(make, geode);
}

void addByAuthor(const Path& path, float width, osg::Geode& geode) {
  PerAuthor<std::vector<Vector3>> segments;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    auto& own = segments[static_cast<std::size_t>(path.points[i].segmentAuthor)];
    own.insert(own.end(), {path.points[i - 1].q.position, path.points[i].q.position});
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].empty()) continue;
    addLinesSeenThrough(segments[i], LineKind::Segments, toOsg(authorColour(static_cast<Author>(i))), width, geode);
  }
}

std::vector<TubePoint> pointsByAuthor(const Path& path) {
  std::vector<TubePoint> points;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const osg::Vec4 colour = toOsg(authorColour(path.points[i].segmentAuthor));
    points.insert(points.end(), {{path.points[i - 1].q.position, colour}, {path.points[i].q.position, colour}});
  }
  return points;
}

bool hasProfile(const PathPicture& picture) {
  return picture.profile != nullptr && picture.profile->samples.size() > 1;
}

std::vector<TubePoint> tubePointsOf(const PathPicture& picture, const ScenePalette& palette) {
  if (picture.byAuthor) return pointsByAuthor(picture.path);
  if (hasProfile(picture)) return pointsByClearance(*picture.profile);
  std::vector<TubePoint> points;
  for (const PathPoint& point : picture.path.points) points.push_back({point.q.position, palette.path});
  return points;
}

/// Adds a faint geometry for the parts that bodies hide, as lines of the window have.
void addHidden(const osg::ref_ptr<osg::Geometry>& faint, osg::Geode& geode) {
  makeUnlit(*faint);
  makeTransparent(*faint);
  osg::StateSet* state = faint->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false));
  state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  geode.addDrawable(faint);
}

/// The path in a headset, as a tube, because lines have no depth there. A ball marks the tightest place.
osg::ref_ptr<osg::Geode> makeSpatialWay(const PathPicture& picture, const ScenePalette& palette) {
  osg::ref_ptr<osg::Geode> way = new osg::Geode;
  way->setNodeMask(kHeadsetOnly);
  std::vector<TubePoint> points = tubePointsOf(picture, palette);
  if (points.empty()) return way;
  way->addDrawable(makeTube(points, picture.tubeRadius));
  for (TubePoint& point : points) point.colour.a() *= kSeenThrough;
  addHidden(makeTube(points, picture.tubeRadius), *way);
  if (!hasProfile(picture)) return way;
  const Pose& tightest = picture.profile->samples[*picture.profile->tightest()].q;
  const BodyShape ball = makeBodyShape(
      transformed(makeSphere(kTightestBall * picture.tubeRadius, 2), Pose::translation(tightest.position)));
  osg::Vec4 colour = clearanceColour(0.0);
  way->addDrawable(makeSurface(ball, colour));
  colour.a() *= kSeenThrough;
  addHidden(makeSurface(ball, colour), *way);
  return way;
}

}  // namespace

osg::Vec4 clearanceColour(double share) {
  constexpr std::array<std::array<float, 3>, 3> kStops{
      {{0.84F, 0.37F, 0.00F}, {0.95F, 0.86F, 0.45F}, {0.00F, 0.45F, 0.70F}}};
  const float place = static_cast<float>(std::clamp(share, 0.0, 1.0)) * (kStops.size() - 1);
  const auto from = std::min<std::size_t>(static_cast<std::size_t>(place), kStops.size() - 2);
  const float to = place - static_cast<float>(from);
  osg::Vec4 colour(0.0F, 0.0F, 0.0F, 1.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    colour[static_cast<int>(i)] = (1.0F - to) * kStops[from][i] + to * kStops[from + 1][i];
  }
  return colour;
}

osg::ref_ptr<osg::Group> makePath(const PathPicture& picture, const ScenePalette& palette) {
  const std::vector<PathPoint>& points = picture.path.points;
  std::vector<Vector3> way;
  for (const PathPoint& point : points) way.push_back(point.q.position);
  osg::ref_ptr<osg::Geode> lines = new osg::Geode;
  lines->addDrawable(
      makeLines(way, LineKind::Strip, osg::Vec4(0.05F, 0.06F, 0.08F, kRimOpacity), kRimWidth * palette.pixelScale));
  const float width = kPathWidth * palette.pixelScale;
  if (picture.byAuthor) {
    addByAuthor(picture.path, width, *lines);
  } else if (hasProfile(picture)) {
    addByClearance(*picture.profile, width, *lines);
  } else {
    addLinesSeenThrough(way, LineKind::Strip, palette.path, width, *lines);
  }
  osg::ref_ptr<osg::Group> group = new osg::Group;
  lines->setNodeMask(kWindowOnly);
  group->addChild(lines);
  group->addChild(makeSpatialWay(picture, palette));
  if (!picture.ghosts.empty()) {
    group->addChild(makeGhosts(picture.object, picture.ghosts, palette.path, palette));
  }
  return group;
}

osg::ref_ptr<osg::Group> makeRefusedPath(const PathExamination& refused, const BodyShape& object,
                                         const ScenePalette& palette) {
  const std::vector<PathPoint>& points = refused.path.points;
  std::vector<bool> isBlocked(points.size(), false);
  for (const BlockedEdge& edge : refused.blocked) isBlocked[edge.edge] = true;
  std::array<std::vector<Vector3>, 2> segments;
  for (std::size_t i = 1; i < points.size(); ++i) {
    auto& kind = segments[isBlocked[i - 1] ? 1 : 0];
    kind.insert(kind.end(), {points[i - 1].q.position, points[i].q.position});
  }
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::ref_ptr<osg::Geode> lines = new osg::Geode;
  const float width = kPathWidth * palette.pixelScale;
  osg::Vec4 faded = palette.path;
  faded.a() = kFaded;
  if (!segments[0].empty()) lines->addDrawable(makeLines(segments[0], LineKind::Segments, faded, width));
  if (!segments[1].empty()) lines->addDrawable(makeLines(segments[1], LineKind::Segments, palette.penetration, width));
  group->addChild(lines);
  for (std::size_t i = 0; i < std::min(kBlockedGhosts, refused.blocked.size()); ++i) {
    const BlockedEdge& edge =
        refused.blocked[i * refused.blocked.size() / std::min(kBlockedGhosts, refused.blocked.size())];
    const Pose& to = points[std::min(edge.edge + 1, points.size() - 1)].q;
    const Pose q = interpolate(points[edge.edge].q, to, edge.at);
    group->addChild(makeGhost(object, q, palette.penetration, palette));
  }
  return group;
}

}  // namespace glissade
