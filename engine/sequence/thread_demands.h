#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/product/judged_threads.h"
#include "engine/product/product_shapes.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"

namespace glissade {

/// The threads that bodies of a product leave by turning only, as the judge asks for it of every step
/// (check::commonThreads()): but for pairs whose joint a person has dissolved, or has pressed out, and where a person
/// uses no joints. Immutable, shared by threads.
class ThreadDemands {
 public:
  using Threads = std::vector<check::CommonThread>;

  /// Refers to the product.
  ThreadDemands(const AssembledProduct& product, const ProductFits& fits, const SequenceDemands& demands);

  /// Of the body while it leaves the other one; null: there are none.
  const Threads* of(std::size_t body, std::size_t other) const;
  /// What of them the motion of the body pulls, for people; empty: nothing.
  std::string pulled(std::size_t body, std::size_t other, const std::vector<Pose>& path) const;
  /// The joints, with one of kind Thread for each pair that has a thread and no joint of any kind.
  Joints withThreads(Joints joints, const ProductShapes& shapes) const;

 private:
  const AssembledProduct& product_;
  std::map<std::pair<std::size_t, std::size_t>, Threads> threads_;  ///< of a body with another one
};

}  // namespace glissade
