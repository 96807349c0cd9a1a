#include "engine/fits/joint_finder.h"

#include <algorithm>
#include <set>

#include "engine/fits/named_joints.h"
#include "engine/fits/pressed_joints.h"
#include "engine/fits/rolling_bearings.h"
#include "engine/fits/suggested_joints.h"
#include "engine/fits/threaded_joints.h"
#include "engine/fits/threaded_parts.h"

namespace glissade {
namespace {

/// Removes hosts from the parts that the screw of their insert clamps: a host is around that screw.
void releaseHosts(const Joints& pressed, Joints& threaded) {
  for (Joint& screw : threaded) {
    std::set<std::size_t> hosts;
    for (const Joint& insert : pressed) {
      const bool isIn = insert.kind == JointKind::Insert &&
                        std::find(screw.others.begin(), screw.others.end(), insert.body) != screw.others.end();
      if (isIn) hosts.insert(insert.others.begin(), insert.others.end());
    }
    const auto isHost = [&](std::size_t body) { return hosts.count(body) != 0; };
    screw.clamped.erase(std::remove_if(screw.clamped.begin(), screw.clamped.end(), isHost), screw.clamped.end());
  }
}

/// Removes joints between bodies of a bearing, which its unit already joins.
void leaveOutInside(const Joints& units, Joints& joints) {
  std::set<std::size_t> inside;
  for (const Joint& unit : units) {
    inside.insert(unit.body);
    inside.insert(unit.others.begin(), unit.others.end());
  }
  const auto isInside = [&](const Joint& joint) {
    return inside.count(joint.body) != 0 &&
           std::all_of(joint.others.begin(), joint.others.end(), [&](std::size_t b) { return inside.count(b) != 0; });
  };
  joints.erase(std::remove_if(joints.begin(), joints.end(), isInside), joints.end());
}

/// Removes pins that a name calls a screw, whatever their heads.
void leaveOutScrews(const Designations& said, Joints& pressed) {
  const auto isScrew = [&](const Joint& joint) {
    return joint.kind == JointKind::Pin && says(said, joint.body, {StandardPart::Screw, StandardPart::SetScrew});
  };
  pressed.erase(std::remove_if(pressed.begin(), pressed.end(), isScrew), pressed.end());
}

/// Removes suggested inserts of pairs that have a thread.
void leaveOutThreaded(const Joints& threads, Joints& joints) {
  std::erase_if(joints, [&](const Joint& insert) {
    const bool isOpen = insert.kind == JointKind::Insert && insert.state == JointState::Suggested;
    return isOpen && std::any_of(threads.begin(), threads.end(), [&](const Joint& thread) {
             return std::minmax(thread.body, thread.others.front()) == std::minmax(insert.body, insert.others.front());
           });
  });
}

void append(Joints more, Joints& joints) {
  for (Joint& joint : more) joints.push_back(std::move(joint));
}

}  // namespace

Joints findJoints(const AssembledProduct& product, const StopToken& stop, const std::vector<std::string>& classes) {
  return findJoints(ProductShapes(product), stop, classes);
}

Joints findJoints(const ProductShapes& shapes, const StopToken& stop, const std::vector<std::string>& classes) {
  const Designations said = designationsOf(shapes.product());
  Joints threaded = findThreadedJoints(shapes, said, stop);
  Joints pressed = findPressedJoints(shapes, threaded, said, stop);
  Joints units = findRollingBearings(shapes, stop);
  releaseHosts(pressed, threaded);
  leaveOutInside(units, pressed);
  leaveOutScrews(said, pressed);
  Joints joints = std::move(threaded);
  append(std::move(pressed), joints);
  append(std::move(units), joints);
  Joints threads = findThreadedParts(shapes, joints, stop);
  leaveOutThreaded(threads, joints);
  append(std::move(threads), joints);
  for (Joint& joint : joints) {
    addDesignations(said, joint);
    if (const TurnedShape* shape = shapes.turned(joint.body)) addUsualDrive(*shape, joint);
  }
  append(findSuggestedJoints(shapes, classes, joints, stop), joints);
  std::stable_sort(joints.begin(), joints.end(),
                   [](const Joint& a, const Joint& b) { return a.body != b.body ? a.body < b.body : a.kind < b.kind; });
  return joints;
}

}  // namespace glissade
