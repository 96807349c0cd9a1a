#pragma once

#include <osg/Array>
#include <osg/ref_ptr>

#include <map>
#include <memory>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// What is uploaded of a mesh: shared by all bodies that have this mesh, whatever their colour and display mode.
struct BodyShape {
  osg::ref_ptr<osg::Vec3Array> corners;  ///< three per triangle
  osg::ref_ptr<osg::Vec3Array> normals;  ///< one per corner, smooth across edges below the feature angle
  osg::ref_ptr<osg::Vec3Array> edges;    ///< ends of the feature edges, two per edge
};

BodyShape makeBodyShape(const TriangleMesh& mesh);

/// The shapes of the meshes that a scene shows. GUI thread only.
class BodyShapes {
 public:
  /// The shape of this mesh; made at the first call.
  const BodyShape& of(const MeshPtr& mesh);
  /// Forgets the shapes of meshes that nobody else holds any more.
  void dropUnused();

 private:
  struct Entry {
    std::weak_ptr<const TriangleMesh> mesh;
    BodyShape shape;
  };
  std::map<const TriangleMesh*, Entry> shapes_;
};

}  // namespace glissade
