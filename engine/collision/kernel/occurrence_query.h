#pragma once

#include <memory>
#include <vector>

#include "engine/collision/kernel/kernel_query.h"
#include "engine/geometry/box_hierarchy.h"

namespace glissade {

/// The geometry of a world in two levels: a hierarchy of boxes over the obstacles in place, and a tree for each mesh,
/// in the frame of the mesh, that all of its occurrences share. Immutable, shared by threads.
struct OccurrenceGeometry {
  struct Occurrence {
    std::shared_ptr<const BoxTree> tree;  ///< of the mesh, made for `scale`; its body has the number 0
    Pose X_WM;                            ///< of the mesh's frame
  };

  /// `boxes`: around the occurrences in the world. `objectBox`: in frame B.
  OccurrenceGeometry(double scale, std::vector<Occurrence> occurrences, const std::vector<Box3>& boxes,
                     std::shared_ptr<const BoxTree> object, const Box3& objectBox);

  /// Another object among the same obstacles.
  void setObject(std::shared_ptr<const BoxTree> tree, const Box3& box);

  double scale;  ///< as KernelGeometry
  std::vector<Occurrence> occurrences;
  BoxHierarchy boxes;  ///< of the occurrences, by their number
  std::shared_ptr<const BoxTree> object;
  Box3 objectBox;            ///< metres, frame B
  double objectReach = 0.0;  ///< of the box from the reference point
};

/// Asks the kernel about each occurrence that the object may reach, in the frame of its mesh, and unites the answers.
/// Answers depend on the pose alone.
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
  KernelQuery one_;  ///< of one occurrence at a time
};

}  // namespace glissade
