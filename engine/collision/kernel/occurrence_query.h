#pragma once

#include <memory>
#include <vector>

#include "engine/collision/kernel/kernel_query.h"
#include "engine/geometry/box_hierarchy.h"

namespace glissade {

/// The geometry of a world in two levels: a hierarchy of boxes over the placed obstacles, and a tree for each mesh, in
/// the frame of the mesh, which all its occurrences share. Immutable, shared by threads.
struct OccurrenceGeometry {
  struct Occurrence {
    std::shared_ptr<const BoxTree> tree;  ///< tree of the mesh with this `scale`; its body has the number 0
    Pose X_WM;                            ///< pose of the mesh's frame
  };

  /// `boxes`: around the occurrences in the world. `objectBox`: in frame B.
  OccurrenceGeometry(double scale, std::vector<Occurrence> occurrences, const std::vector<Box3>& boxes,
                     std::shared_ptr<const BoxTree> object, const Box3& objectBox);

  /// Replaces the object; the obstacles stay.
  void setObject(std::shared_ptr<const BoxTree> tree, const Box3& box);

  double scale;  ///< as in KernelGeometry
  std::vector<Occurrence> occurrences;
  BoxHierarchy boxes;  ///< boxes of the occurrences, by their number
  std::shared_ptr<const BoxTree> object;
  Box3 objectBox;            ///< bounding box of the object, metres, frame B
  double objectReach = 0.0;  ///< largest distance of the box from the reference point
};

/// Queries the kernel for each occurrence that the object may reach, in the frame of its mesh, and combines the
/// answers. Answers depend on the pose only.
class OccurrenceQuery final : public SurfaceQuery {
 public:
  explicit OccurrenceQuery(std::shared_ptr<const OccurrenceGeometry> geometry);

  bool touches(const Pose& X_WB) override;
  std::optional<int> touchingBody(const Pose& X_WB) override;
  NearestObstacle nearest(const Pose& X_WB, double enough) override;
  bool isWithin(const Pose& X_WB, double bound) override;
  std::optional<MotionCheck> checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                         const StopToken& stop) override;
  std::uint64_t pairs() const override { return one_.pairs(); }

 private:
  Box3 boxAt(const Pose& X_WB) const;
  Box3 boxOfMotion(const Pose& from, const Pose& to) const;
  KernelQuery& ask(std::uint32_t occurrence);
  Pose seenFrom(std::uint32_t occurrence, const Pose& X_WB) const;
  MotionCheck checkUnambiguous(const Pose& from, const Pose& to, double required, SeekViolation seek,
                               const StopToken& stop);

  std::shared_ptr<const OccurrenceGeometry> geometry_;
  KernelQuery one_;  ///< query of one occurrence at a time
};

}  // namespace glissade
