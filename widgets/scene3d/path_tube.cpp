#include "widgets/scene3d/path_tube.h"

#include <cmath>
#include <numbers>

#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr int kSides = 8;

/// The directions of the ways before and after each point, in the mean.
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

/// One ring about a point.
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

/// Triangles between each two rings.
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

}  // namespace

osg::ref_ptr<osg::Geometry> makeTube(const std::vector<TubePoint>& points, double radius) {
  osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
  const std::vector<Vector3> tangents = tangentsOf(points);
  Vector3 u = Vector3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 tangent = tangents[i].norm() > 0.0 ? Vector3(tangents[i].normalized()) : Vector3::UnitZ();
    // The rings turn as little as they can, so that the tube is not twisted.
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

}  // namespace glissade
