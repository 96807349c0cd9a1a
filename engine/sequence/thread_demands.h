#pragma once

#include <map>
#include <utility>
#include <vector>

#include "engine/base/message.h"
#include "engine/fits/judged_threads.h"
#include "engine/fits/product_shapes.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"

namespace glissade {

/// The threads that bodies of a product leave by turning only, as the judge demands of every step
/// (evidence::commonThreads()). Pairs whose joint a person has dissolved or pressed out are left out, and so are all
/// pairs if the demands use no joints. Not all after a stop. Immutable, shared by threads.
class ThreadDemands {
 public:
  using Threads = std::vector<evidence::CommonThread>;

  /// Refers to the product.
  ThreadDemands(const AssembledProduct& product, const ProductFits& fits, const SequenceDemands& demands,
                const StopToken& stop);

  /// The threads of the body while it leaves the other body; null: there are none.
  const Threads* of(std::size_t body, std::size_t other) const;
  /// The threads of the pair that the motion of the body pulls, as a text for people; empty: none.
  Message pulled(std::size_t body, std::size_t other, const std::vector<Pose>& path) const;
  /// The joints, and a joint of kind Thread for each pair that has a thread and no joint of any kind.
  Joints withThreads(Joints joints, const ProductShapes& shapes) const;

 private:
  const AssembledProduct& product_;
  std::map<std::pair<std::size_t, std::size_t>, Threads> threads_;  ///< by leaving body and other body
};

}  // namespace glissade
