#include "engine/sequence/thread_demands.h"

#include <algorithm>
#include <set>

#include "engine/fits/named_joints.h"
#include "engine/fits/threaded_parts.h"

namespace glissade {
namespace {

using BodyPair = std::pair<std::size_t, std::size_t>;

/// Pairs whose joint a person has dissolved or pressed out; the last statement about a pair counts.
std::set<BodyPair> partedBy(const std::vector<JointEdit>& edits, const AssembledProduct& product) {
  std::set<BodyPair> parted;
  for (const JointEdit& edit : edits) {
    const bool parts = edit.word == JointEdit::Word::Dissolved || edit.word == JointEdit::Word::PressedOut;
    const auto body = product.indexOf(edit.key.body);
    for (const std::string& id : edit.key.others) {
      const auto other = product.indexOf(id);
      if (!body || !other) continue;
      const BodyPair pair = std::minmax(*body, *other);
      parted.erase(pair);
      if (parts) parted.insert(pair);
    }
  }
  return parted;
}

}  // namespace

ThreadDemands::ThreadDemands(const AssembledProduct& product, const ProductFits& fits, const SequenceDemands& demands,
                             const StopToken& stop)
    : product_(product) {
  if (demands.jointUse == JointUse::Off) return;
  JudgedThreads judged(product);
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    std::map<std::size_t, std::vector<Fit>> byOther;
    for (const Fit& fit : fits.fitsOf(body)) byOther[fit.obstacle].push_back(fit);
    for (const auto& [other, ofPair] : byOther) {
      Threads threads = judged.of(body, other, ofPair, stop);
      if (!threads.empty()) threads_[{body, other}] = std::move(threads);
    }
  }
  for (const auto& pair : partedBy(demands.joints, product)) {
    threads_.erase(pair);
    threads_.erase({pair.second, pair.first});
  }
}

const ThreadDemands::Threads* ThreadDemands::of(std::size_t body, std::size_t other) const {
  const auto found = threads_.find({body, other});
  return found == threads_.end() ? nullptr : &found->second;
}

Message ThreadDemands::pulled(std::size_t body, std::size_t other, const std::vector<Pose>& path) const {
  const Threads* threads = of(body, other);
  return threads == nullptr ? Message() : evidence::pulledThread(*threads, path);
}

Joints ThreadDemands::withThreads(Joints joints, const ProductShapes& shapes) const {
  std::set<BodyPair> joined;
  for (const Joint& joint : joints) {
    std::vector<std::size_t> bodies{joint.body};
    bodies.insert(bodies.end(), joint.others.begin(), joint.others.end());
    for (const std::size_t one : bodies) {
      for (const std::size_t other : bodies) joined.emplace(one, other);
    }
  }
  const auto said = designationsOf(product_);
  for (const auto& [pair, threads] : threads_) {
    if (!joined.insert(pair).second) continue;
    joined.emplace(pair.second, pair.first);
    Joint joint = jointOfThread(shapes, pair, threads);
    addDesignations(said, joint);
    joints.push_back(std::move(joint));
  }
  return joints;
}

}  // namespace glissade
