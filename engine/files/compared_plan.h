#pragma once

#include <string>
#include <vector>

#include "engine/files/product_file.h"
#include "engine/sequence/product_changes.h"

namespace glissade {

/// A step of an earlier plan in a later revision of the product.
struct ComparedStep {
  std::string number;                 ///< number in the order of assembly, in the earlier plan
  std::vector<std::string> bodies{};  ///< names
  std::vector<std::string> gone{};    ///< names of those bodies that the later revision lacks
  bool holds = false;                 ///< what is left of it does
  Message why{};                      ///< the reason why it does not hold
};

/// An earlier plan in a later revision of the product.
struct ComparedPlan {
  std::vector<ComparedStep> steps{};       ///< in the order of assembly; steps inside of groups are not compared
  std::vector<std::string> withoutStep{};  ///< names of bodies of the later revision

  std::size_t holding() const;
  bool holds() const { return holding() == steps.size() && withoutStep.empty(); }
};

/// Judges each step of the plan in the later revision. `before`: the product of the plan. `changes`: the differences of
/// the two.
ComparedPlan comparePlan(const AssemblyPlan& plan, const AssembledProduct& before, ProductFile now,
                         const ProductChanges& changes, const StopToken& stop = {});

/// A line for each difference, and their numbers.
std::vector<Message> inWords(const ProductChanges& changes, const AssembledProduct& before,
                             const AssembledProduct& now);

/// A line for each step that does not hold and for each part without a step, and their numbers.
std::vector<Message> inWords(const ComparedPlan& plan);

}  // namespace glissade
