#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/product/assembled_product.h"
#include "engine/product/joint.h"

namespace glissade {

/// The key of a joint of this product.
JointKey keyOf(const Joint& joint, const AssembledProduct& product);

/// The joints after what a person says of them: confirmed, dissolved, made, changed. An insert that is pressed out
/// becomes a pin along its axis; a unit that is opened is none any more. What is said last of a joint counts. Errors,
/// Usage, one at a time, with the joint as the location: a body that is not there, bodies that are far apart, a joint
/// of a body with itself, a word about a joint that is not there, an unknown standard, a bend that no hook has, joints
/// that hold each other in a circle.
Result<Joints> applied(Joints joints, const std::vector<JointEdit>& edits, const AssembledProduct& product);

/// A joint as it is, confirmed. The bend of a hook is said with it.
JointEdit confirmationOf(const Joint& joint, const AssembledProduct& product);

/// Every joint that is suggested, as confirmed: --joints suggested.
std::vector<JointEdit> confirmationsOf(const Joints& joints, const AssembledProduct& product);

/// The bends that a person confirms of hooks; what is said last of a snap counts.
std::vector<check::SnapWord> bendsOf(const std::vector<JointEdit>& edits);

/// The bends of the snaps that count.
std::vector<check::SnapWord> bendsOf(const Joints& joints, const AssembledProduct& product);

/// The edits, with what counts of the joints' bends said by a person: a plan states what it rests on.
std::vector<JointEdit> withBends(std::vector<JointEdit> edits, const Joints& joints, const AssembledProduct& product);

/// "screw of bolt": what people see of a key.
std::string inWords(const JointKey& key);

}  // namespace glissade
