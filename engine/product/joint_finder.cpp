#include "engine/product/joint_finder.h"

#include <algorithm>

#include "engine/product/threaded_joints.h"

namespace glissade {

Joints findJoints(const AssembledProduct& product, const StopToken& stop) {
  const ProductShapes shapes(product);
  Joints joints = findThreadedJoints(shapes, stop);
  std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.body < b.body; });
  return joints;
}

}  // namespace glissade
