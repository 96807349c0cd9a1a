#pragma once

#include <map>
#include <memory>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "widgets/scene3d/late_details.h"
#include "widgets/scene3d/shape_detail.h"

namespace glissade {

/// The uploaded arrays of a mesh, shared by all bodies that have this mesh, whatever their colour and display mode. The
/// arrays of the base are those of the whole mesh.
struct BodyShape : ShapeDetail {
  std::shared_ptr<LateDetails> coarser;  ///< for bodies that are small on the screen; null: there are none
};

BodyShape makeBodyShape(const TriangleMesh& mesh);

/// The shapes of the meshes that a scene shows. Used on the GUI thread only.
class BodyShapes {
 public:
  /// The shape of this mesh, made by the first call.
  const BodyShape& of(const MeshPtr& mesh);
  /// Forgets the shapes of meshes that nothing else refers to.
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
