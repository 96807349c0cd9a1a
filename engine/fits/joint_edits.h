#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/fits/assembled_product.h"
#include "engine/fits/joint.h"

namespace glissade {

JointKey keyOf(const Joint& joint, const AssembledProduct& product);

/// The joints after a person's statements: confirmed, dissolved, made, changed. An insert that is pressed out becomes a
/// pin along its axis; an opened unit is removed. The last statement about a joint counts. Errors, Usage, one at a
/// time, with the joint as the location: a body that does not exist, bodies that are far apart, a joint of a body with
/// itself, a statement about a joint that does not exist, an unknown standard, a bend that no hook has, joints that
/// hold each other in a circle.
Result<Joints> applied(Joints joints, const std::vector<JointEdit>& edits, const AssembledProduct& product);

/// A statement that confirms the joint, with the bend of its hook.
JointEdit confirmationOf(const Joint& joint, const AssembledProduct& product);

/// Statements that confirm every suggested joint (--joints suggested).
std::vector<JointEdit> confirmationsOf(const Joints& joints, const AssembledProduct& product);

/// The bends of hooks that a person confirms; the last statement about a snap counts.
std::vector<evidence::SnapWord> bendsOf(const std::vector<JointEdit>& edits);

/// The bends of the snaps that count.
std::vector<evidence::SnapWord> bendsOf(const Joints& joints, const AssembledProduct& product);

/// The edits, with the bends of the joints as a person's statements: a plan states the bends that it depends on.
std::vector<JointEdit> withBends(std::vector<JointEdit> edits, const Joints& joints, const AssembledProduct& product);

/// "screw of bolt": the key for people.
Message inWords(const JointKey& key);

}  // namespace glissade
