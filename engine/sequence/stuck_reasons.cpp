#include "engine/sequence/stuck_reasons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "engine/base/number_text.h"
#include "engine/evidence/hook.h"
#include "engine/fits/fit_refusals.h"
#include "engine/fits/snap_ways.h"
#include "engine/geometry/separate_solids.h"

namespace glissade {
namespace {

/// "+X" or "−Z"; the numbers of another direction.
std::string wayText(const Vector3& direction) {
  constexpr std::array kAxes{"+X", "−X", "+Y", "−Y", "+Z", "−Z"};
  constexpr double kAlongAxis = 0.9999;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto name = static_cast<std::size_t>(2 * axis);
    if (direction[axis] > kAlongAxis) return kAxes[name];
    if (direction[axis] < -kAlongAxis) return kAxes[name + 1];
  }
  const auto digits = [](double value) { return toText(0.01 * std::round(100.0 * value) + 0.0); };  // + 0.0: no "-0"
  return "(" + digits(direction.x()) + ", " + digits(direction.y()) + ", " + digits(direction.z()) + ")";
}

}  // namespace

BodyGroup unitOf(std::size_t body, const OrderRules& rules) {
  for (const BodyGroup& group : rules.together) {
    if (std::binary_search(group.begin(), group.end(), body)) return group;
  }
  return {body};
}

Message StuckReasons::of(std::size_t body, const std::vector<std::size_t>& holding,
                         const std::set<std::size_t>& blocking) const {
  const Message reason = withoutAdvice(body, holding, blocking);
  std::set<std::size_t> involved = blocking;
  involved.insert(body);
  for (const std::size_t each : involved) {
    const Message solids = aboutSolids(each);
    if (!solids.empty()) return joined({reason, solids}, "; ");
  }
  return reason;
}

/// A part of a CAD file whose solids hang together nowhere may be several parts; empty where it is none.
Message StuckReasons::aboutSolids(std::size_t body) const {
  constexpr double kTouchingSolids = 5e-5;  // metres: what tessellation is off
  const TriangleMesh& mesh = *question_.product.bodies[body].mesh;
  const std::size_t count = mesh.faces.empty() ? 1 : separateSolids(mesh, kTouchingSolids);
  if (count < 2) return {};
  return {GLISSADE_TEXT("'%1' is one part of %2 solids that do not touch each other: split it (--open \"%3\", or "
                        "\"Split OBJ groups and solids\" in the list of parts)"),
          {name(body), count, name(body)}};
}

Message StuckReasons::withoutAdvice(std::size_t body, const std::vector<std::size_t>& holding,
                                    const std::set<std::size_t>& blocking) const {
  const BodyGroup unit = unitOf(body, question_.rules);
  if (Message joints = ofJoints(unit); !joints.empty()) return joints;
  if (Message clashes = ofClashes(unit); !clashes.empty()) return clashes;
  if (!holding.empty())
    return {GLISSADE_TEXT("a constraint states that '%1' is removed before"), {name(holding.front())}};
  if (stop_.stopRequested()) return GLISSADE_TEXT("planning was stopped before every motion of it was tried");
  if (Message snaps = ofSnaps(unit); !snaps.empty()) return snaps;
  for (const std::size_t other : blocking) {
    if (question_.staying[other] || !holdEachOther(body, other)) continue;
    if (Message alone = ofOneAlone(unit, blocking); !alone.empty()) return alone;
    if (Message stuck = ofStuckBlocker(unit); !stuck.empty()) return stuck;
    return {GLISSADE_TEXT("it and '%1' hold each other: no motion was found for either alone, nor for both as one; "
                          "motions of several bodies at the same time are not searched"),
            {name(other)}};
  }
  if (question_.rules.motionOf(unit) != nullptr) return GLISSADE_TEXT("its motion by hand is not free");
  if (!question_.rules.forbiddenTo(unit).empty()) {
    return GLISSADE_TEXT("no motion was found in a direction that is not ruled out");
  }
  if (isCaged(unit, blocking)) {
    return GLISSADE_TEXT("it is between parts that are pressed together: press one of them out");
  }
  if (Message turns = ofTurns(unit); !turns.empty()) return turns;
  if (Message cuts = ofCuts(unit, blocking); !cuts.empty()) return cuts;
  if (Message alone = ofOneAlone(unit, blocking); !alone.empty()) return alone;
  if (Message stuck = ofStuckBlocker(unit); !stuck.empty()) return stuck;
  return GLISSADE_TEXT("no motion was found, alone or with others");
}

/// Names a present body that blocks a straight motion of the unit, and that joints or a clash hold; empty if there is
/// none.
Message StuckReasons::ofStuckBlocker(const BodyGroup& unit) const {
  for (const std::size_t other : bodiesIn(without(present_, unit))) {
    if (question_.staying[other] || !isBlockedDirectlyBy(unit, other)) continue;
    const BodyGroup others = unitOf(other, question_.rules);
    if (ofJoints(others).empty() && ofClashes(others).empty()) continue;
    return {GLISSADE_TEXT("'%1' is in its way, and is stuck for a reason of its own"), {name(other)}};
  }
  return {};
}

bool StuckReasons::isBlockedDirectlyBy(const BodyGroup& unit, std::size_t other) const {
  const auto refused = refusals_.find(unit);
  if (refused == refusals_.end()) return false;
  const auto direct = refused->second.find(0);
  if (direct == refused->second.end()) return false;
  const std::vector<std::size_t>& blocking = direct->second.blockedBy;
  return std::find(blocking.begin(), blocking.end(), other) != blocking.end();
}

/// Names a body that stays and blocks the unit without any other body; empty if there is none.
Message StuckReasons::ofOneAlone(const BodyGroup& unit, const std::set<std::size_t>& blocking) const {
  for (const std::size_t other : blocking) {
    if (!question_.staying[other] || !blocksAlone(unit, other)) continue;
    const Message alone{
        GLISSADE_TEXT("'%1' alone blocks every straight motion of it, and no other motion was found; if '%1' is "
                      "several parts drawn as one, such as a bolt with its nut, draw them apart"),
        {name(other)}};
    const Message snap = asSnap(unit, other);
    return snap.empty() ? alone : joined({alone, snap}, "; ");
  }
  return {};
}

/// True if all blocking bodies, at least two, belong to one other unit.
bool StuckReasons::isCaged(const BodyGroup& unit, const std::set<std::size_t>& blocking) const {
  if (question_.joints == nullptr || blocking.size() < 2) return false;
  for (const BodyGroup& bonded : question_.joints->bonded()) {
    if (bonded != unit && std::includes(bonded.begin(), bonded.end(), blocking.begin(), blocking.end())) return true;
  }
  return false;
}

/// "held by 4 screws M3x8: remove these first", and the reason why these do not leave; empty if no joint holds the
/// unit.
Message StuckReasons::ofJoints(const BodyGroup& unit) const {
  if (question_.joints == nullptr) return {};
  const std::vector<std::size_t> joints = question_.joints->holding(unit, present_, false);
  if (joints.empty()) return {};
  const Message words = question_.joints->inWords(joints);
  for (const std::size_t body : question_.joints->holders(joints, unit, present_)) {
    if (!isBlockedBy(unitOf(body, question_.rules), unit)) continue;
    return {GLISSADE_TEXT("held by %1: remove these first; '%2' is captive: '%3' is in its way"),
            {words, name(body), name(unit.front())}};
  }
  return {GLISSADE_TEXT("held by %1: remove these first"), {words}};
}

/// Says which bend is missing of a snap that counts and holds the unit; empty if there is none.
Message StuckReasons::ofSnaps(const BodyGroup& unit) const {
  if (question_.joints == nullptr) return {};
  const auto isOwn = [&](std::size_t body) { return std::binary_search(unit.begin(), unit.end(), body); };
  const auto isThere = [&](std::size_t body) { return static_cast<bool>(present_[body]); };
  for (const Joint& joint : question_.joints->joints()) {
    if (joint.kind != JointKind::Snap || !isThere(joint.body)) continue;
    if (!std::all_of(joint.others.begin(), joint.others.end(), isThere)) continue;
    const bool hasHook = isOwn(joint.body);
    if (hasHook == std::any_of(joint.others.begin(), joint.others.end(), isOwn)) continue;
    if (Message bend = ofBend(joint, hasHook); !bend.empty()) return bend;
  }
  return {};
}

/// `hasHook`: the hook is on the stuck unit, not on the body that holds it. Empty if the stated bend is enough.
Message StuckReasons::ofBend(const Joint& snap, bool hasHook) const {
  const auto least = leastBend(question_.product, snap.body, snap.others, snap.direction, stop_);
  if (least && *least <= snap.bend) return {};
  const std::string& other = name(hasHook ? snap.others.front() : snap.body);
  const std::string way = wayText(hasHook ? snap.direction : Vector3(-snap.direction));
  if (least) {
    return {
        GLISSADE_TEXT("the snap with '%1' was tried in the direction %2 with a bend of %3, and needs %4: change the "
                      "joint to this bend"),
        {other, way, Length{snap.bend}, Length{*least}}};
  }
  return {GLISSADE_TEXT("the snap with '%1' was tried in the direction %2, and the most that its hook can bend, %3, is "
                        "too little: change the direction of the joint, or move the part by hand"),
          {other, way, Length{evidence::mostBendOf(*question_.product.bodies[snap.body].mesh)}}};
}

/// Tries the unit and the body that holds it as a snap that nobody has stated; empty for large meshes and groups.
Message StuckReasons::asSnap(const BodyGroup& unit, std::size_t other) const {
  constexpr std::size_t kMostTriangles = 20'000;  // larger meshes take seconds
  const auto& bodies = question_.product.bodies;
  const std::size_t own = unit.front();
  const std::size_t triangles = bodies[own].mesh->triangles.size() + bodies[other].mesh->triangles.size();
  if (unit.size() > 1 || triangles > kMostTriangles) return {};
  for (const bool hasHook : {true, false}) {
    const std::size_t hook = hasHook ? own : other;
    for (const SnapWay& way : snapWays(question_.product, hook, {hasHook ? other : own}, stop_)) {
      if (!(way.bend > 0.0)) continue;
      return {
          GLISSADE_TEXT("it would leave in the direction %1 if '%2' bends by %3: make the two a snap with this bend"),
          {wayText(hasHook ? way.direction : Vector3(-way.direction)), name(hook), Length{way.bend}}};
    }
  }
  const double most = std::max(evidence::mostBendOf(*bodies[own].mesh), evidence::mostBendOf(*bodies[other].mesh));
  return {GLISSADE_TEXT("as a snap that bends by up to %1 it leaves along no axis: move it by hand, or make the two a "
                        "permanent joint"),
          {Length{most}}};
}

/// Says that the unit is in a thread and cannot be turned out; empty if it is in none.
Message StuckReasons::ofTurns(const BodyGroup& unit) const {
  if (question_.joints == nullptr) return {};
  const std::vector<std::size_t> opened = question_.joints->opened(unit, present_);
  const BodyGroup holders = question_.joints->holders(opened, unit, present_);
  if (holders.empty()) return {};
  return {GLISSADE_TEXT("it is held by %1 in '%2', and cannot be unscrewed: clear the space, or dissolve the joint"),
          {question_.joints->inWords(opened), name(holders.front())}};
}

/// Names a present body that it was not compared with, or else the deepest clash with one; empty if there is none.
Message StuckReasons::ofClashes(const BodyGroup& unit) const {
  if (question_.fits == nullptr) return {};
  const Fit* deepest = nullptr;
  std::size_t clashing = unit.front();
  for (const std::size_t other : bodiesIn(without(present_, unit))) {
    for (const std::size_t body : unit) {
      if (!question_.fits->areCompared(body, other)) {
        return {GLISSADE_TEXT("it and '%1' were not compared within the time limit: give more time"), {name(other)}};
      }
      const Fit* clash = question_.fits->clashOf(body, other);
      if (clash == nullptr || (deepest != nullptr && clash->overlap <= deepest->overlap)) continue;
      deepest = clash;
      clashing = body;
    }
  }
  if (deepest == nullptr) return {};
  if (deepest->cut) return ofRefusedClash(clashing, *deepest);
  // If the bodies only touch, the table of fits says why none is thinned.
  constexpr double kOverlap = 1e-5;
  if (deepest->overlap < kOverlap) {
    return {GLISSADE_TEXT("it and '%1' clash where they are assembled: mend the parts, or accept the clash"),
            {name(deepest->obstacle)}};
  }
  return {GLISSADE_TEXT("it and '%1' clash where they are assembled (%2): mend the parts, or accept the clash"),
          {name(deepest->obstacle), Depth{deepest->overlap}}};
}

/// Says why a clash holds the body whether it is accepted or not.
Message StuckReasons::ofRefusedClash(std::size_t body, const Fit& clash) const {
  const std::string& other = name(clash.obstacle);
  const Depth depth{clash.overlap};
  if (*clash.cut == evidence::Cut::NotClear) {
    return {
        GLISSADE_TEXT("the clash of it and '%1' (%2) is accepted, and which of the two is cut is not clear: name the "
                      "one that is cut (--cut \"%3\" or --cut \"%1\")"),
        {other, depth, name(body)}};
  }
  return {
      GLISSADE_TEXT("it and '%1' clash where they are assembled (%2), and neither can be cut and stay in one piece: "
                    "mend the parts"),
      {other, depth}};
}

/// Names the body that could be cut for an accepted clash of the unit; empty if there is none.
Message StuckReasons::ofCuts(const BodyGroup& unit, const std::set<std::size_t>& blocking) const {
  if (question_.fits == nullptr) return {};
  for (const std::size_t body : unit) {
    for (const std::size_t other : blocking) {
      const Fit* clash = question_.fits->acceptedClashOf(body, other);
      if (clash == nullptr) continue;
      return {GLISSADE_TEXT("no motion was found: %1"), {adviceToCut(*clash, name(body), name(other))}};
    }
  }
  return {};
}

bool StuckReasons::isBlockedBy(const BodyGroup& unit, const BodyGroup& others) const {
  const auto refused = refusals_.find(unit);
  if (refused == refusals_.end()) return false;
  return std::any_of(refused->second.begin(), refused->second.end(), [&](const auto& each) {
    const std::vector<std::size_t>& blocking = each.second.blockedBy;
    return std::any_of(blocking.begin(), blocking.end(),
                       [&](std::size_t body) { return std::binary_search(others.begin(), others.end(), body); });
  });
}

/// True if the unit has no direct way out while nothing but the other body is there.
bool StuckReasons::blocksAlone(const BodyGroup& unit, std::size_t other) const {
  if (isBlockedDirectlyBy(unit, other) && refusals_.at(unit).at(0).blockedBy.size() == 1) return true;
  BodySet pair(present_.size(), false);
  for (const std::size_t body : unit) pair[body] = true;
  pair[other] = true;
  const RemovalAnswer answer = question_.trial.tryRemoval(unit, pair, 0, {});
  const auto* held = std::get_if<Refused>(&answer);
  return held != nullptr && !held->stopped;
}

/// True if `body` blocks the unit of `other`, which blocks `body`.
bool StuckReasons::holdEachOther(std::size_t body, std::size_t other) const {
  return isBlockedBy(unitOf(other, question_.rules), {body});
}

}  // namespace glissade
