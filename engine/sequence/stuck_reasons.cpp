#include "engine/sequence/stuck_reasons.h"

#include <algorithm>
#include <variant>

#include "engine/fits/fit_refusals.h"
#include "engine/geometry/separate_solids.h"

namespace glissade {

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
    return {GLISSADE_TEXT("'%1' alone blocks every straight motion of it, and no other motion was found; if '%1' is "
                          "several parts drawn as one, such as a bolt with its nut, draw them apart"),
            {name(other)}};
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

/// Says that the unit is in a thread and cannot be turned out; empty if it is in none.
Message StuckReasons::ofTurns(const BodyGroup& unit) const {
  if (question_.joints == nullptr) return {};
  const std::vector<std::size_t> opened = question_.joints->opened(unit, present_);
  const BodyGroup holders = question_.joints->holders(opened, unit, present_);
  if (holders.empty()) return {};
  return {GLISSADE_TEXT("it is held by %1 in '%2', and cannot be unscrewed: clear the space, or dissolve the joint"),
          {question_.joints->inWords(opened), name(holders.front())}};
}

/// Names the deepest clash with a present body; empty if there is none.
Message StuckReasons::ofClashes(const BodyGroup& unit) const {
  if (question_.fits == nullptr) return {};
  const Fit* deepest = nullptr;
  std::size_t clashing = unit.front();
  for (const std::size_t other : bodiesIn(without(present_, unit))) {
    for (const std::size_t body : unit) {
      const Fit* clash = question_.fits->clashOf(body, other);
      if (clash == nullptr || (deepest != nullptr && clash->overlap <= deepest->overlap)) continue;
      deepest = clash;
      clashing = body;
    }
  }
  if (deepest == nullptr) return {};
  if (deepest->cut) return ofAcceptedClash(clashing, *deepest);
  // If the bodies only touch, the table of fits says why none is thinned.
  constexpr double kOverlap = 1e-5;
  if (deepest->overlap < kOverlap) {
    return {GLISSADE_TEXT("it and '%1' clash where they are assembled: mend the parts, or accept the clash"),
            {name(deepest->obstacle)}};
  }
  return {GLISSADE_TEXT("it and '%1' clash where they are assembled (%2): mend the parts, or accept the clash"),
          {name(deepest->obstacle), Depth{deepest->overlap}}};
}

/// Says why a clash that is accepted still holds the body.
Message StuckReasons::ofAcceptedClash(std::size_t body, const Fit& clash) const {
  const std::string& other = name(clash.obstacle);
  const Depth depth{clash.overlap};
  if (*clash.cut == evidence::Cut::NotClear) {
    return {
        GLISSADE_TEXT("the clash of it and '%1' (%2) is accepted, and which of the two is cut is not clear: name the "
                      "one that is cut (--cut \"%3\" or --cut \"%1\")"),
        {other, depth, name(body)}};
  }
  return {GLISSADE_TEXT("the clash of it and '%1' (%2) is accepted, and neither can be cut and stay in one piece: mend "
                        "the parts"),
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
