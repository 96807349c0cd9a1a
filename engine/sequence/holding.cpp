#include "engine/sequence/holding.h"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/geometry/joined_sets.h"

namespace glissade {
namespace {

bool isAnyThere(const std::vector<std::size_t>& bodies, const BodySet& there) {
  return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t body) { return there[body]; });
}

/// True if the fastener and a body that it is screwed or pressed into are there.
bool isWhole(const Joint& joint, const BodySet& there) { return there[joint.body] && isAnyThere(joint.others, there); }

}  // namespace

Holding::Holding(const SequenceQuestion& question) : question_(question), initial_(question.initial()) {
  if (question.joints != nullptr) {
    for (const Joint& joint : question.joints->joints()) {
      if (isScrewed(joint.kind) || joint.kind == JointKind::Pin) fastening_.push_back(&joint);
    }
  }
  joined_ = bodiesIn(joinedToBase(initial_));
}

bool Holding::isInAir(const BodyGroup& group, const BodySet& remaining) const {
  const LiaisonGraph* graph = question_.liaisons;
  if (graph == nullptr || graph->liaisons().empty()) return false;
  const BodySet reached = reachedFrom(bodiesIn(question_.staying), remaining);
  return std::none_of(group.begin(), group.end(),
                      [&](std::size_t body) { return isAnyThere(graph->neighboursOf(body), reached); });
}

/// The bodies of `there` that a chain of contacts and joints between them connects to one of `from`.
BodySet Holding::reachedFrom(const BodyGroup& from, const BodySet& there) const {
  BodySet reached(there.size(), false);
  BodyGroup open;
  const auto reach = [&](std::size_t body) {
    if (!there[body] || reached[body]) return;
    reached[body] = true;
    open.push_back(body);
  };
  for (const std::size_t body : from) reach(body);
  while (!open.empty()) {
    const std::size_t body = open.back();
    open.pop_back();
    for (const std::size_t other : question_.liaisons->neighboursOf(body)) reach(other);
  }
  return reached;
}

BodySet Holding::floating(const BodySet& there) const {
  const BodySet reached = reachedFrom(bodiesIn(question_.staying), there);
  BodySet floating = there;
  for (std::size_t body = 0; body < there.size(); ++body) {
    if (reached[body] || question_.liaisons->neighboursOf(body).empty()) floating[body] = false;
  }
  return floating;
}

std::vector<BodyGroup> Holding::connectedParts(const BodySet& set) const {
  std::vector<BodyGroup> parts;
  BodySet open = set;
  for (std::size_t body = 0; body < set.size(); ++body) {
    if (!open[body]) continue;
    parts.push_back(bodiesIn(reachedFrom({body}, open)));
    open = without(std::move(open), parts.back());
  }
  return parts;
}

std::size_t Holding::unfastened(const BodySet& remaining) const {
  const BodySet joined = joinedToBase(remaining);
  return static_cast<std::size_t>(std::count_if(joined_.begin(), joined_.end(),
                                                [&](std::size_t body) { return remaining[body] && !joined[body]; }));
}

std::size_t Holding::openStacks(const BodySet& remaining) const {
  if (question_.joints == nullptr) return 0;
  const std::vector<BodyGroup>& stacks = question_.joints->stacks();
  return static_cast<std::size_t>(std::count_if(stacks.begin(), stacks.end(), [&](const BodyGroup& stack) {
    const auto hasLeft = [&](std::size_t body) { return initial_[body] && !remaining[body]; };
    return isAnyThere(stack, remaining) && std::any_of(stack.begin(), stack.end(), hasLeft);
  }));
}

BodySet Holding::joinedToBase(const BodySet& there) const {
  JoinedSets sets(there.size());
  const auto join = [&](std::size_t one, std::size_t other) {
    if (there[other]) sets.join(static_cast<std::uint32_t>(one), static_cast<std::uint32_t>(other));
  };
  for (const Joint* joint : fastening_) {
    if (!isWhole(*joint, there)) continue;
    for (const std::size_t other : joint->others) join(joint->body, other);
    for (const std::size_t clamped : joint->clamped) join(joint->body, clamped);
  }
  const std::vector<std::uint32_t> setOf = std::move(sets).all();
  std::set<std::uint32_t> ofBase;
  for (const std::size_t body : bodiesIn(question_.staying)) ofBase.insert(setOf[body]);
  BodySet joined(there.size(), false);
  for (std::size_t body = 0; body < there.size(); ++body) joined[body] = there[body] && ofBase.count(setOf[body]) != 0;
  return joined;
}

}  // namespace glissade
