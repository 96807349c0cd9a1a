#include "widgets/scene3d/section_caps.h"

#include <osgUtil/Tessellator>

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"
#include "widgets/scene3d/section_layer.h"

namespace glissade {
namespace {

/// Cut faces are darker than the surface, to distinguish them from it.
constexpr float kCapShade = 0.72F;
constexpr float kOutlineWidth = 1.8F;
/// Largest number of triangles that is cut at once, which takes some milliseconds; the rest is left for another thread.
constexpr std::size_t kAtOnceTriangles = 60'000;

using Polygons = std::vector<std::vector<Vector3>>;

/// The inside of polygons by the even-odd rule.
osg::ref_ptr<osg::Geometry> fillOf(const Polygons& polygons, const osg::Vec4& colour) {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
  for (const std::vector<Vector3>& polygon : polygons) {
    const auto first = static_cast<int>(points->size());
    for (const Vector3& point : polygon) points->push_back(toOsg(point));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_LINE_LOOP, first, static_cast<int>(polygon.size())));
  }
  geometry->setVertexArray(points);
  osg::ref_ptr<osgUtil::Tessellator> tessellator = new osgUtil::Tessellator;
  tessellator->setTessellationType(osgUtil::Tessellator::TESS_TYPE_GEOMETRY);
  tessellator->setWindingType(osgUtil::Tessellator::TESS_WINDING_ODD);
  tessellator->setBoundaryOnly(false);
  tessellator->retessellatePolygons(*geometry);
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
  colours->push_back(colour);
  geometry->setColorArray(colours, osg::Array::BIND_OVERALL);
  makeUnlit(*geometry);
  return geometry;
}

/// All outlines in one drawing, because a body may have thousands.
osg::ref_ptr<osg::Geometry> outlinesOf(const Polygons& polygons, const ScenePalette& palette) {
  std::vector<Vector3> segments;
  for (const std::vector<Vector3>& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      segments.insert(segments.end(), {polygon[i], polygon[(i + 1) % polygon.size()]});
    }
  }
  return makeLines(segments, LineKind::Segments, palette.lines, kOutlineWidth * palette.pixelScale);
}

bool isSame(const Plane& a, const Plane& b) { return a.normal == b.normal && a.offset == b.offset; }

}  // namespace

osg::ref_ptr<osg::Group> makeCap(const TriangleMesh& mesh, const Plane& section, const osg::Vec4& colour,
                                 const ScenePalette& palette) {
  const Polygons polygons = planeSection(mesh, section);
  if (polygons.empty()) return nullptr;
  osg::Vec4 shaded = colour * kCapShade;
  shaded.a() = 1.0F;
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(fillOf(polygons, shaded));
  geode->addDrawable(outlinesOf(polygons, palette));
  osg::ref_ptr<osg::Group> cap = new osg::Group;
  cap->addChild(geode);
  return cap;
}

void SectionCaps::show(const std::vector<Plane>& sections, const std::vector<CapBody>& bodies,
                       const ScenePalette& palette) {
  palette_ = palette;
  colours_.clear();
  for (const CapBody& body : bodies) colours_.push_back(body.colour);
  root_->removeChildren(0, root_->getNumChildren());
  sections_.resize(std::min(sections.size(), kMostSections));
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    Section& section = sections_[i];
    root_->addChild(section.group);
    // The other sections cut the caps of this one.
    for (std::size_t other = 0; other < kMostSections; ++other) {
      const bool cuts = other < sections_.size() && other != i;
      section.group->getOrCreateStateSet()->setMode(GL_CLIP_PLANE0 + static_cast<GLenum>(other),
                                                    cuts ? osg::StateAttribute::ON : osg::StateAttribute::OFF);
    }
    section.caps.resize(bodies.size());
    section.group->removeChildren(0, section.group->getNumChildren());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      Cap& cap = section.caps[b];
      section.group->addChild(cap.node);
      showCap(cap, bodies[b], sections[i], triangles);
    }
  }
}

void SectionCaps::showCap(Cap& cap, const CapBody& body, const Plane& section, std::size_t& triangles) {
  cap.node->setNodeMask(body.shown ? ~0U : 0U);
  if (!body.shown) return;
  cap.node->setMatrix(toOsg(body.X_WB));
  const Plane plane_B = planeInBody(section, body.X_WB);
  if (cap.mesh == body.mesh && isSame(cap.plane_B, plane_B)) return;
  cap.mesh = body.mesh;
  cap.plane_B = plane_B;
  cap.isLeft = false;
  cap.node->removeChildren(0, cap.node->getNumChildren());
  if (!meets(*body.mesh, plane_B)) return;
  triangles += body.mesh->triangles.size();
  if (triangles > kAtOnceTriangles) {
    cap.isLeft = true;
  } else if (const auto face = makeCap(*body.mesh, plane_B, body.colour, palette_)) {
    cap.node->addChild(face);
  }
}

bool SectionCaps::meets(const TriangleMesh& mesh, const Plane& plane) {
  const auto [entry, isNew] = boxes_.try_emplace(&mesh);
  if (isNew) entry->second = boundingBox(mesh);
  const Box3& box = entry->second;
  if (box.isEmpty()) return false;
  const double reach = 0.5 * plane.normal.cwiseAbs().dot(box.sizes());
  return std::abs(plane.normal.dot(box.center()) - plane.offset) <= reach * (1.0 + 1e-9);
}

void SectionCaps::forget() {
  sections_.clear();
  boxes_.clear();
}

bool SectionCaps::hasLeft() const {
  return std::any_of(sections_.begin(), sections_.end(), [](const Section& section) {
    return std::any_of(section.caps.begin(), section.caps.end(), [](const Cap& cap) { return cap.isLeft; });
  });
}

SectionCaps::Work SectionCaps::work() {
  std::vector<Order> orders;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    for (std::size_t b = 0; b < sections_[i].caps.size(); ++b) {
      const Cap& cap = sections_[i].caps[b];
      if (cap.isLeft) orders.push_back({i, b, cap.mesh, cap.plane_B, colours_[b]});
    }
  }
  if (orders.empty()) return {};
  return [this, orders, palette = palette_](const WorkWatch& watch) -> std::function<void()> {
    std::vector<osg::ref_ptr<osg::Group>> faces;
    for (const Order& order : orders) {
      if (watch.stop.stopRequested()) return [] {};
      faces.push_back(makeCap(*order.mesh, order.plane_B, order.colour, palette));
    }
    return [this, orders, faces] {
      for (std::size_t i = 0; i < orders.size(); ++i) take(orders[i], faces[i]);
    };
  };
}

/// Takes a cut face. If its body or section has moved meanwhile, it is left for the next work.
void SectionCaps::take(const Order& order, osg::Group* face) {
  if (order.section >= sections_.size() || order.body >= sections_[order.section].caps.size()) return;
  Cap& cap = sections_[order.section].caps[order.body];
  if (!cap.isLeft || cap.mesh != order.mesh || !isSame(cap.plane_B, order.plane_B)) return;
  cap.isLeft = false;
  if (face != nullptr) cap.node->addChild(face);
}

}  // namespace glissade
