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
/// Makes lines of points that are shared.
osg::ref_ptr<osg::Geometry> makeLines(const osg::ref_ptr<osg::Vec3Array>& points, LineKind kind,
                                      const osg::Vec4& colour, float width);

/// Opacity of hidden parts that show through bodies.
inline constexpr float kSeenThrough = 0.4F;
/// Adds a geometry that is fainter where a body hides it. Precondition: its parent is transparent.
void addSeenThrough(const std::function<osg::ref_ptr<osg::Geometry>(float opacity)>& make, osg::Geode& geode);
/// Adds lines that are fainter where a body hides them.
void addLinesSeenThrough(const std::vector<Vector3>& points, LineKind kind, const osg::Vec4& colour, float width,
                         osg::Geode& geode);

/// Points with a size in pixels.
osg::ref_ptr<osg::Geometry> makePoints(const std::vector<Vector3>& points, const osg::Vec4& colour, float size);

/// A filled disc about `centre` with the given normal.
osg::ref_ptr<osg::Geometry> makeDisc(const Vector3& centre, const Vector3& normal, double radius,
                                     const osg::Vec4& colour);

/// The twelve edges of a box as segment ends.
std::vector<Vector3> boxEdges(const Box3& box);

/// Makes lines or points unlit, and draws them after the see-through surfaces, which would paint over them.
void makeDrawing(osg::Node& node);
/// Draws the node over everything that was drawn before: the depth tests of its parts are overridden.
void makeOverlay(osg::Node& node);
/// Blends a see-through surface, which then hides nothing.
void makeTransparent(osg::Node& node);
/// Marks the pixels of the node, which nodes that avoid marks do not paint over.
void makeMarking(osg::Node& node);
void makeAvoidMarks(osg::Node& node);
/// Switches lighting off, so that the colour is unchanged.
void makeUnlit(osg::Node& node);

}  // namespace glissade
