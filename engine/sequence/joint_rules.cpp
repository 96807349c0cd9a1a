#include "engine/sequence/joint_rules.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace glissade {
namespace {

bool has(const BodyGroup& group, std::size_t body) { return std::binary_search(group.begin(), group.end(), body); }

bool hasAny(const BodyGroup& group, const std::vector<std::size_t>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t body) { return has(group, body); });
}

bool isBonded(const Joint& joint) {
  return joint.kind == JointKind::Insert || joint.kind == JointKind::Permanent || joint.kind == JointKind::Unit;
}

/// "M3x8" or "ISO 4762 M3x8"; the size of the thread if there is no designation.
std::string sizeInWords(const Joint& joint) {
  if (!joint.designation.empty()) return joint.designation;
  if (!joint.thread || joint.thread->diameter <= 0.0) return {};
  const long tenths = std::lround(1e4 * joint.thread->diameter);
  std::string text = "of " + std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
  return text + " mm";
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
  findTasks(product);
}

void JointRules::bond(const AssembledProduct& product) {
  std::vector<std::size_t> first(product.bodies.size());  // the lowest body that each body is bonded to
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (const Joint& joint : joints_) {
    if (!isBonded(joint)) continue;
    for (const std::size_t other : joint.others) {
      const auto [low, high] = std::minmax(first[joint.body], first[other]);
      const std::size_t from = high;
      const std::size_t to = low;
      std::replace(first.begin(), first.end(), from, to);
    }
  }
  std::map<std::size_t, BodyGroup> groups;
  for (std::size_t body = 0; body < first.size(); ++body) groups[first[body]].push_back(body);
  for (auto& [body, group] : groups) {
    if (group.size() > 1) bonded_.push_back(std::move(group));
  }
}

/// Joints are alike by designation, or by thread and drive without one. Bolts with nuts are tasks apart from other
/// screws.
void JointRules::findTasks(const AssembledProduct& product) {
  using Key = std::tuple<JointKind, bool, std::string, std::vector<long>, std::vector<std::size_t>>;
  std::map<Key, std::vector<std::size_t>> alike;
  std::vector<Key> order;
  for (const Joint& joint : joints_) {
    if (!isScrewed(joint.kind) || joint.clamped.empty()) continue;
    std::vector<std::size_t> clamped = joint.clamped;
    std::sort(clamped.begin(), clamped.end());
    const auto sizes = joint.designation.empty() ? sizesOf(joint) : std::vector<long>();
    for (const bool isBolt : {false, true}) {
      if (isBolt && (joint.kind != JointKind::Nut || joint.others.size() != 1)) continue;
      const Key key{joint.kind, isBolt, joint.designation, sizes, clamped};
      const auto [at, isNew] = alike.try_emplace(key);
      if (isNew) order.push_back(key);
      at->second.push_back(isBolt ? joint.others.front() : joint.body);
    }
  }
  tasks_.assign(product.bodies.size(), 0);
  std::size_t number = 0;
  for (const Key& key : order) {
    const std::vector<std::size_t>& bodies = alike[key];
    if (bodies.size() < 2) continue;
    ++number;
    for (const std::size_t body : bodies) tasks_[body] = number;
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

std::string JointRules::inWords(const std::vector<std::size_t>& joints) const {
  std::map<std::pair<JointKind, std::string>, std::set<std::size_t>> alike;
  for (const std::size_t index : joints) {
    alike[{joints_[index].kind, sizeInWords(joints_[index])}].insert(joints_[index].body);
  }
  std::string text;
  for (const auto& [what, bodies] : alike) {
    text += text.empty() ? "held by " : " and ";
    text += std::to_string(bodies.size()) + " " + kJointKindNames.of(what.first) + (bodies.size() > 1 ? "s" : "");
    if (!what.second.empty()) text += " " + what.second;
  }
  return text;
}

}  // namespace glissade
