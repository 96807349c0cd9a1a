#include "widgets/scene3d/path_layer.h"

#include <osg/Depth>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "widgets/document/author_colour.h"
#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr float kPathWidth = 4.0F;
/// A dark rim keeps the path legible before bodies of any colour.
constexpr float kRimWidth = 7.0F;
constexpr float kRimOpacity = 0.55F;
/// Of the object where a path is blocked.
constexpr std::size_t kBlockedGhosts = 7;
constexpr float kFaded = 0.45F;
/// Opacity of the part of a path that bodies hide.
constexpr float kHiddenPath = 0.4F;

/// A line that is fainter where a body hides it.
void addSeenThrough(const std::function<osg::ref_ptr<osg::Geometry>(float opacity)>& make, osg::Geode& geode) {
  geode.addDrawable(make(1.0F));
  osg::ref_ptr<osg::Geometry> hidden = make(kHiddenPath);
  hidden->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false));
  geode.addDrawable(hidden);
}

void addLines(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour, float width,
              osg::Geode& geode) {
  const auto make = [&](float opacity) {
    return makeLines(points, kind, osg::Vec4(colour.r(), colour.g(), colour.b(), opacity * colour.a()), width);
  };
  addSeenThrough(make, geode);
}

void addByClearance(const ClearanceProfile& profile, float width, osg::Geode& geode) {
  const auto [least, most] =
      std::minmax_element(profile.samples.begin(), profile.samples.end(),
                          [](const auto& a, const auto& b) { return a.nearest.distance < b.nearest.distance; });
  constexpr double kSmallest = 1e-9;  // metres: logarithms need more than 0
  const double low = std::log(std::max(kSmallest, least->nearest.distance));
  const double range = std::log(std::max(kSmallest, most->nearest.distance)) - low;
  std::vector<Vector3> way;
  std::vector<double> shares;
  for (const ClearanceSample& sample : profile.samples) {
    way.push_back(sample.q.position);
    shares.push_back(range > 0.0 ? (std::log(std::max(kSmallest, sample.nearest.distance)) - low) / range : 1.0);
  }
  const auto make = [&](float opacity) {
    osg::ref_ptr<osg::Geometry> line = makeLines(way, LineKind::Strip, {}, width);
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    for (const double share : shares) {
      const osg::Vec4 colour = clearanceColour(share);
      colours->push_back({colour.r(), colour.g(), colour.b(), opacity});
    }
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
    addLines(segments[i], LineKind::Segments, toOsg(authorColour(static_cast<Author>(i))), width, geode);
  }
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
  } else if (picture.profile != nullptr && picture.profile->samples.size() > 1) {
    addByClearance(*picture.profile, width, *lines);
  } else {
    addLines(way, LineKind::Strip, palette.path, width, *lines);
  }
  osg::ref_ptr<osg::Group> group = new osg::Group;
  group->addChild(lines);
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
