#pragma once

#include <map>
#include <memory>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "widgets/scene3d/late_details.h"
#include "widgets/scene3d/shape_detail.h"

namespace glissade {

/// What is uploaded of a mesh: shared by all bodies that have this mesh, whatever their colour and display mode. The
/// arrays of the shape itself are those of the whole mesh.
struct BodyShape : ShapeDetail {
  std::shared_ptr<LateDetails> coarser;  ///< for bodies that are small on the screen; null: there are none
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
  std::shared_ptr<DetailWorker> worker_ = std::make_shared<DetailWorker>();
  std::map<const TriangleMesh*, Entry> shapes_;
};

}  // namespace glissade
