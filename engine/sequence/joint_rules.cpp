#include "engine/sequence/joint_rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "engine/geometry/joined_sets.h"

namespace glissade {
namespace {

bool has(const BodyGroup& group, std::size_t body) { return std::binary_search(group.begin(), group.end(), body); }

bool hasAny(const BodyGroup& group, const std::vector<std::size_t>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t body) { return has(group, body); });
}

/// "M3x8" or "ISO 4762 M3x8"; the size of the thread if there is no designation.
Message sizeInWords(const Joint& joint) {
  if (!joint.designation.empty()) return Message(joint.designation);
  if (!joint.thread || joint.thread->diameter <= 0.0) return {};
  const long tenths = std::lround(1e4 * joint.thread->diameter);
  std::string millimetres = std::to_string(tenths / 10);
  if (tenths % 10 != 0) millimetres += "." + std::to_string(tenths % 10);
  return {GLISSADE_TEXT("of %1 mm"), {millimetres}};
}

/// Texts for a number of joints of one kind, with their size and without.
struct CountTexts {
  CatalogueText one;
  CatalogueText several;
  CatalogueText oneOfSize;
  CatalogueText severalOfSize;
};

/// Only joints of these kinds hold bodies.
CountTexts countTexts(JointKind kind) {
  if (kind == JointKind::Screw) {
    return {GLISSADE_TEXT("%1 screw"), GLISSADE_TEXT("%1 screws"), GLISSADE_TEXT("%1 screw %2"),
            GLISSADE_TEXT("%1 screws %2")};
  }
  if (kind == JointKind::Nut) {
    return {GLISSADE_TEXT("%1 nut"), GLISSADE_TEXT("%1 nuts"), GLISSADE_TEXT("%1 nut %2"), GLISSADE_TEXT("%1 nuts %2")};
  }
  if (kind == JointKind::Thread) {
    return {GLISSADE_TEXT("%1 thread"), GLISSADE_TEXT("%1 threads"), GLISSADE_TEXT("%1 thread %2"),
            GLISSADE_TEXT("%1 threads %2")};
  }
  return {GLISSADE_TEXT("%1 flexible"), GLISSADE_TEXT("%1 flexibles"), GLISSADE_TEXT("%1 flexible %2"),
          GLISSADE_TEXT("%1 flexibles %2")};
}

/// "4 screws M3x8"
Message countInWords(JointKind kind, std::size_t count, const Message& size) {
  const CountTexts texts = countTexts(kind);
  if (size.empty()) return {count == 1 ? texts.one : texts.several, {count}};
  return {count == 1 ? texts.oneOfSize : texts.severalOfSize, {count, size}};
}

/// Sizes of thread and drive, in steps of ten micrometres.
std::vector<long> sizesOf(const Joint& joint) {
  constexpr double kPerMetre = 1e5;
  std::vector<long> sizes{static_cast<long>(joint.drive), std::lround(kPerMetre * joint.driveSize)};
  if (!joint.thread) return sizes;
  for (const double length : {joint.thread->diameter, joint.thread->pitch, joint.thread->engaged}) {
    sizes.push_back(std::lround(kPerMetre * length));
  }
  return sizes;
}

}  // namespace

bool isBonded(const Joint& joint) {
  return joint.kind == JointKind::Insert || joint.kind == JointKind::Permanent || joint.kind == JointKind::Unit;
}

Joints countingJoints(const Joints& joints, JointUse use) {
  Joints counting;
  if (use == JointUse::Off) return counting;
  std::copy_if(joints.begin(), joints.end(), std::back_inserter(counting),
               [&](const Joint& joint) { return use == JointUse::Suggested || joint.state != JointState::Suggested; });
  return counting;
}

JointRules::JointRules(Joints joints, const AssembledProduct& product, const std::vector<FastenerKind>& fasteners)
    : joints_(std::move(joints)),
      ofBody_(product.bodies.size()),
      isFlexible_(product.bodies.size(), false),
      isNut_(product.bodies.size(), false) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (joint.kind == JointKind::Flexible) isFlexible_[joint.body] = true;
    if (joint.kind == JointKind::Nut) isNut_[joint.body] = true;
    for (const std::size_t other : joint.others) {
      if (isScrewed(joint.kind) && fasteners[other] == FastenerKind::Nut) isNut_[other] = true;
    }
    if (!isScrewed(joint.kind) && joint.kind != JointKind::Flexible) continue;
    std::set<std::size_t> bodies{joint.body};
    bodies.insert(joint.others.begin(), joint.others.end());
    bodies.insert(joint.clamped.begin(), joint.clamped.end());
    for (const std::size_t body : bodies) ofBody_[body].push_back(i);
  }
  bond(product);
  findStacks(fasteners);
  findTasks(product);
}

void JointRules::bond(const AssembledProduct& product) {
  JoinedSets bonds(product.bodies.size());
  for (const Joint& joint : joints_) {
    if (!isBonded(joint)) continue;
    for (const std::size_t other : joint.others) {
      bonds.join(static_cast<std::uint32_t>(joint.body), static_cast<std::uint32_t>(other));
    }
  }
  bonded_ = std::move(bonds).several();
}

void JointRules::findStacks(const std::vector<FastenerKind>& fasteners) {
  JoinedSets sets(isNut_.size());
  const auto join = [&](std::size_t one, std::size_t other) {
    sets.join(static_cast<std::uint32_t>(one), static_cast<std::uint32_t>(other));
  };
  for (const Joint& joint : joints_) {
    if (joint.kind != JointKind::Screw && joint.kind != JointKind::Nut) continue;
    for (const std::size_t other : joint.others) {
      if (joint.kind == JointKind::Nut || isNut_[other]) join(joint.body, other);
    }
    for (const std::size_t clamped : joint.clamped) {
      if (fasteners[clamped] == FastenerKind::Washer) join(joint.body, clamped);
    }
  }
  stacks_ = std::move(sets).several();
  stackOf_.assign(isNut_.size(), 0);
  for (std::size_t i = 0; i < stacks_.size(); ++i) {
    for (const std::size_t body : stacks_[i]) stackOf_[body] = i + 1;
  }
}

/// Joints are alike by designation, or by thread and drive without one, if they clamp the same bodies beside their
/// washers.
void JointRules::findTasks(const AssembledProduct& product) {
  using Key = std::tuple<JointKind, std::string, std::vector<long>, std::vector<std::size_t>>;
  std::map<Key, std::set<std::size_t>> alike;
  std::vector<Key> order;
  for (const Joint& joint : joints_) {
    const std::size_t stack = stackOf_[joint.body];
    if (!isScrewed(joint.kind) || (joint.clamped.empty() && stack == 0)) continue;
    const BodyGroup own = stack == 0 ? BodyGroup{joint.body} : stacks_[stack - 1];
    std::vector<std::size_t> clamped = joint.clamped;
    std::erase_if(clamped, [&](std::size_t body) { return has(own, body); });
    std::sort(clamped.begin(), clamped.end());
    // Stacks that clamp nothing are alike to no other stack.
    if (clamped.empty()) clamped = own;
    const Key key{joint.kind, joint.designation, joint.designation.empty() ? sizesOf(joint) : std::vector<long>(),
                  clamped};
    const auto [at, isNew] = alike.try_emplace(key);
    if (isNew) order.push_back(key);
    at->second.insert(own.begin(), own.end());
  }
  tasks_.assign(product.bodies.size(), 0);
  std::size_t number = 0;
  for (const Key& key : order) {
    if (alike[key].size() < 2) continue;
    ++number;
    for (const std::size_t body : alike[key]) tasks_[body] = number;
  }
}

bool JointRules::isClosed(const Joint& joint, const BodySet& present) const {
  return present[joint.body] &&
         std::any_of(joint.others.begin(), joint.others.end(), [&](std::size_t other) { return present[other]; });
}

std::vector<std::size_t> JointRules::jointsOf(const BodyGroup& group) const {
  std::set<std::size_t> joints;
  for (const std::size_t body : group) joints.insert(ofBody_[body].begin(), ofBody_[body].end());
  return {joints.begin(), joints.end()};
}

std::vector<std::size_t> JointRules::holding(const BodyGroup& group, const BodySet& present, bool strict) const {
  std::vector<std::size_t> found;
  for (const std::size_t index : jointsOf(group)) {
    const Joint& joint = joints_[index];
    if (joint.kind == JointKind::Flexible) {
      if (present[joint.body] && !has(group, joint.body)) found.push_back(index);
      continue;
    }
    const bool clamps = hasAny(group, joint.clamped);
    if (!isClosed(joint, present)) {
      if (strict && clamps && present[joint.body] && !has(group, joint.body)) found.push_back(index);
      continue;
    }
    const auto there = [&](std::size_t other) { return present[other]; };
    const auto leaves = [&](std::size_t other) { return !there(other) || has(group, other); };
    const bool all = std::all_of(joint.others.begin(), joint.others.end(), leaves);
    const bool some = hasAny(group, joint.others);
    const bool turns = has(group, joint.body);
    if (turns && all) continue;
    // A nut is turned off its shaft; the part that a screw is in stays.
    const bool screwStays = !turns && some && joint.kind == JointKind::Screw &&
                            std::none_of(group.begin(), group.end(), [&](std::size_t body) { return isNut_[body]; });
    if (clamps || screwStays || (turns && some)) found.push_back(index);
  }
  return found;
}

std::vector<std::size_t> JointRules::opened(const BodyGroup& group, const BodySet& present) const {
  std::vector<std::size_t> found;
  const BodySet others = without(present, group);
  for (const std::size_t index : jointsOf(group)) {
    const Joint& joint = joints_[index];
    if (!isScrewed(joint.kind) || !joint.thread) continue;
    const auto stays = [&](std::size_t other) { return others[other]; };
    const bool threadStays = std::any_of(joint.others.begin(), joint.others.end(), stays);
    const bool leaves = has(group, joint.body) ? threadStays : hasAny(group, joint.others) && others[joint.body];
    if (leaves) found.push_back(index);
  }
  return found;
}

bool JointRules::isScrewedTogether(std::size_t body) const {
  return std::any_of(ofBody_[body].begin(), ofBody_[body].end(), [&](std::size_t index) {
    const Joint& joint = joints_[index];
    return isScrewed(joint.kind) &&
           (joint.body == body || std::find(joint.others.begin(), joint.others.end(), body) != joint.others.end());
  });
}

BodyGroup JointRules::holders(const std::vector<std::size_t>& joints, const BodyGroup& group,
                              const BodySet& present) const {
  std::set<std::size_t> bodies;
  for (const std::size_t index : joints) {
    const Joint& joint = joints_[index];
    if (!has(group, joint.body)) {
      if (present[joint.body]) bodies.insert(joint.body);
      continue;
    }
    for (const std::size_t other : joint.others) {
      if (present[other] && !has(group, other)) bodies.insert(other);
    }
  }
  return {bodies.begin(), bodies.end()};
}

std::vector<std::pair<std::size_t, std::size_t>> JointRules::links(const BodySet& present) const {
  std::vector<std::pair<std::size_t, std::size_t>> links;
  for (const Joint& joint : joints_) {
    if (!isScrewed(joint.kind) || !isClosed(joint, present)) continue;
    for (const std::size_t other : joint.others) {
      if (!present[other]) continue;
      links.emplace_back(joint.body, other);
      links.emplace_back(other, joint.body);
    }
    for (const std::size_t clamped : joint.clamped) {
      if (present[clamped]) links.emplace_back(joint.body, clamped);
    }
  }
  return links;
}

Message JointRules::inWords(const std::vector<std::size_t>& joints) const {
  struct Alike {
    Message size;
    std::set<std::size_t> bodies;
  };
  std::map<std::pair<JointKind, std::string>, Alike> alike;
  for (const std::size_t index : joints) {
    const Message size = sizeInWords(joints_[index]);
    Alike& each = alike[{joints_[index].kind, toString(size)}];
    each.size = size;
    each.bodies.insert(joints_[index].body);
  }
  Message words;
  for (const auto& [what, each] : alike) {
    const Message next = countInWords(what.first, each.bodies.size(), each.size);
    words = words.empty() ? next : Message(GLISSADE_TEXT("%1 and %2"), {words, next});
  }
  return words;
}

}  // namespace glissade
