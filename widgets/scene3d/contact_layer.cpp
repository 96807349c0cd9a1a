#include "widgets/scene3d/contact_layer.h"

#include <osg/Depth>

#include <array>
#include <cmath>

#include "widgets/document/author_colour.h"
#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr float kPointSize = 8.0F;
constexpr float kPathWidth = 4.0F;
constexpr std::size_t kGhosts = 7;
constexpr float kFaded = 0.45F;
/// Opacity of the part of a path that bodies hide.
constexpr float kHiddenPath = 0.4F;
/// Share of the contact disc that is drawn: all of it would hide the scene.
constexpr double kDrawnDisc = 0.5;

/// Lines, fainter where a body hides them.
void addSeenThrough(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour, float width,
                    osg::Geode& geode) {
  geode.addDrawable(makeLines(points, kind, colour, width));
  const osg::Vec4 faint(colour.r(), colour.g(), colour.b(), kHiddenPath * colour.a());
  osg::ref_ptr<osg::Geometry> hidden = makeLines(points, kind, faint, width);
  hidden->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false));
  geode.addDrawable(hidden);
}

}  // namespace

osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  const NearestObstacle& nearest = snapshot.device.nearest;
  if (nearest.body < 0 || nearest.distance <= 0.0 || !std::isfinite(nearest.distance)) return group;
  const bool near = nearest.distance < snapshot.parameters[ParameterId::ContactDistance];
  const osg::Vec4 colour = near ? palette.contact : palette.nearest;
  osg::ref_ptr<osg::Geode> marks = new osg::Geode;
  const std::vector<Vector3> pair{nearest.p_WPo, nearest.p_WPn};
  marks->addDrawable(makeLines(pair, LineKind::Segments, colour, (near ? 3.0F : 1.5F) * palette.pixelScale));
  marks->addDrawable(makePoints(pair, colour, kPointSize * palette.pixelScale));
  // Seen through whatever lies in front: it tells where contact is.
  marks->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
  group->addChild(marks);
  if (!near) return group;
  const double radius = kDrawnDisc * snapshot.parameters[ParameterId::ContactRadius];
  osg::ref_ptr<osg::Geode> plane = new osg::Geode;
  osg::Vec4 fill = palette.contact;
  fill.a() = snapshot.contactMode ? 0.35F : 0.15F;
  plane->addDrawable(makeDisc(nearest.p_WPo, nearest.normal_W(), radius, fill));
  group->addChild(plane);
  return group;
}

osg::ref_ptr<osg::Group> makePath(const Path& path, const BodyShape& object, const ScenePalette& palette,
                                  bool byAuthor) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  PerAuthor<std::vector<Vector3>> segments;
  std::vector<Vector3> way;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    way.push_back(path.points[i].q.position);
    if (i == 0) continue;
    auto& own = segments[static_cast<std::size_t>(path.points[i].segmentAuthor)];
    own.insert(own.end(), {way[i - 1], way[i]});
  }
  osg::ref_ptr<osg::Geode> line = new osg::Geode;
  const float width = kPathWidth * palette.pixelScale;
  for (std::size_t i = 0; byAuthor && i < segments.size(); ++i) {
    if (segments[i].empty()) continue;
    const osg::Vec4 colour = toOsg(authorColour(static_cast<Author>(i)));
    addSeenThrough(segments[i], LineKind::Segments, colour, width, *line);
  }
  if (!byAuthor) addSeenThrough(way, LineKind::Strip, palette.path, width, *line);
  group->addChild(line);
  const std::size_t count = std::min(kGhosts, path.points.size());
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Pose& q = path.points[i * (path.points.size() - 1) / (count - 1)].q;
    group->addChild(makeGhost(object, q, palette.path, palette));
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
  for (std::size_t i = 0; i < std::min(kGhosts, refused.blocked.size()); ++i) {
    const BlockedEdge& edge = refused.blocked[i * refused.blocked.size() / std::min(kGhosts, refused.blocked.size())];
    const Pose& to = points[std::min(edge.edge + 1, points.size() - 1)].q;
    const Pose q = interpolate(points[edge.edge].q, to, edge.at);
    group->addChild(makeGhost(object, q, palette.penetration, palette));
  }
  return group;
}

}  // namespace glissade
