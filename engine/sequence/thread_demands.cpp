#include "engine/sequence/thread_demands.h"

#include <algorithm>
#include <set>

#include "engine/fits/fit_words.h"
#include "engine/fits/named_joints.h"
#include "engine/fits/threaded_parts.h"

namespace glissade {
namespace {

using BodyPair = std::pair<std::size_t, std::size_t>;

}  // namespace

ThreadDemands::ThreadDemands(const AssembledProduct& product, const ProductFits& fits, const SequenceDemands& demands,
                             const StopToken& stop)
    : product_(product) {
  if (demands.jointUse == JointUse::Off) return;
  JudgedThreads judged(product, partingsOf(demands.joints));
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    std::map<std::size_t, std::vector<Fit>> byOther;
    for (const Fit& fit : fits.fitsOf(body)) byOther[fit.obstacle].push_back(fit);
    for (const auto& [other, ofPair] : byOther) {
      Threads threads = judged.of(body, other, ofPair, stop);
      if (!threads.empty()) threads_[{body, other}] = std::move(threads);
    }
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
