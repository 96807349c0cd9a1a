#pragma once

#include <osg/Array>
#include <osg/ref_ptr>

#include <vector>

#include "engine/base/stop_token.h"

namespace glissade {

/// The arrays by which a mesh is drawn.
struct ShapeDetail {
  osg::ref_ptr<osg::Vec3Array> corners;  ///< three per triangle
  osg::ref_ptr<osg::Vec3Array> normals;  ///< one per corner, smooth across edges below the feature angle
  osg::ref_ptr<osg::Vec3Array> edges;    ///< ends of the feature edges, two per edge
  double error = 0.0;                    ///< approximate distance of the surface from the mesh, metres
  double edgeDensity = 0.0;              ///< metres of feature edges for each square metre of faces
};

double edgeDensity(const ShapeDetail& detail);

/// A mesh of fewer triangles has no coarser details.
inline constexpr std::size_t kFewestTrianglesOfDetails = 1000;

/// Coarser arrays of a mesh, the finest first, each with at most 0.6 of the triangles of the one before. Vertices of a
/// cell of a grid become one (Rossignac and Borrel 1993): the vertex of the least quadric error (Garland and Heckbert
/// 1997). Empty for meshes of few triangles (kFewestTrianglesOfDetails). The arrays are for display only. A stop leaves
/// out the rest.
std::vector<ShapeDetail> coarserDetails(const ShapeDetail& finest, const StopToken& stop = {});

}  // namespace glissade
