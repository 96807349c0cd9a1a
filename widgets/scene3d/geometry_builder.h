#pragma once

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/ref_ptr>

#include <functional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "widgets/scene3d/body_shape.h"

namespace glissade {

/// Unlit triangles in one colour.
osg::ref_ptr<osg::Geometry> makeFlatSurface(const TriangleMesh& mesh, const osg::Vec4& colour);

/// The surface of a shape in one colour; its arrays are shared.
osg::ref_ptr<osg::Geometry> makeSurface(const ShapeDetail& shape, const osg::Vec4& colour);

/// A set of separate line segments, or a polyline.
enum class LineKind { Segments, Strip };
osg::ref_ptr<osg::Geometry> makeLines(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour,
                                      float width);
/// The same of points that are shared.
osg::ref_ptr<osg::Geometry> makeLines(const osg::ref_ptr<osg::Vec3Array>& points, LineKind kind,
                                      const osg::Vec4& colour, float width);

/// Opacity of what bodies hide, where it is seen through them.
inline constexpr float kSeenThrough = 0.4F;
/// What is fainter where a body hides it. Its parent is transparent.
void addSeenThrough(const std::function<osg::ref_ptr<osg::Geometry>(float opacity)>& make, osg::Geode& geode);
/// Lines of makeLines(), the same.
void addLinesSeenThrough(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour, float width,
                         osg::Geode& geode);

/// Points of a size in pixels.
osg::ref_ptr<osg::Geometry> makePoints(const std::vector<Vector3>& points, const osg::Vec4& colour, float size);

/// A filled disc about `centre` with the given normal.
osg::ref_ptr<osg::Geometry> makeDisc(const Vector3& centre, const Vector3& normal, double radius,
                                     const osg::Vec4& colour);

/// The twelve edges of a box as segment ends.
std::vector<Vector3> boxEdges(const Box3& box);

/// For lines and points: unlit, and drawn after the see-through surfaces, which would paint over them.
void makeDrawing(osg::Node& node);
/// Drawn over everything that was drawn before it: the depth tests of its parts are overridden.
void makeOverlay(osg::Node& node);
/// For surfaces that are seen through: blended, hiding nothing.
void makeTransparent(osg::Node& node);
/// Without lighting: the colour as it is.
void makeUnlit(osg::Node& node);

}  // namespace glissade
