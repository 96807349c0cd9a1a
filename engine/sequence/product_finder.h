#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/fits/fit_table.h"
#include "engine/fits/joint.h"
#include "engine/sequence/fits_store.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/product_fits.h"

namespace glissade {

using JointsPtr = std::shared_ptr<const Joints>;

/// The joints and fits of a product, found before its sequence is planned.
struct ProductFindings {
  Joints joints;     ///< with the person's edits among the demands; none if the demands use none
  ProductFits fits;  ///< with the bends of the joints that count
};

/// Finds the fits and joints of products, for the window and the command line. Answers about the last products are
/// remembered, so that the panels and the sequence share them. Thread-safe: a second asker waits for the answer.
class ProductFinder {
 public:
  /// `store` keeps fits for later runs; null: none does.
  explicit ProductFinder(std::unique_ptr<FitsStore> store = nullptr) : store_(std::move(store)) {}

  /// The table of fits, whether the product's fits are on or not. `limits`: nothing for FitTable::whole(). `watch`,
  /// `deadlines` and errors: see FitTable::find(). A table that lacks pairs is not remembered.
  Result<FitTablePtr> fits(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch,
                           const std::optional<ContactLimits>& limits = ContactLimits(),
                           const std::optional<FitDeadlines>& deadlines = {});
  /// The joints that are found without a person, by findJoints(); null after a stop.
  JointsPtr joints(const AssembledProduct& product, const std::vector<std::string>& classes, const StopToken& stop);
  /// Errors: those of fits() and applied(). After a stop the error is Interrupted.
  Result<ProductFindings> findings(const AssembledProduct& product, const std::vector<std::string>& classes,
                                   const SequenceDemands& demands, ThreadTeam& team, const WorkWatch& watch,
                                   const std::optional<FitDeadlines>& deadlines = {});

 private:
  struct KnownFits {
    AssembledProduct product;
    std::optional<ContactLimits> limits;
    FitTablePtr table;
  };
  struct KnownJoints {
    AssembledProduct product;
    std::vector<std::string> classes;
    JointsPtr joints;
  };

  Result<FitTable> found(const AssembledProduct& product, const ContactLimits& limits, ThreadTeam& team,
                         const WorkWatch& watch, const std::optional<FitDeadlines>& deadlines);

  std::unique_ptr<FitsStore> store_;
  std::mutex fitsMutex_;
  std::mutex jointsMutex_;
  std::deque<KnownFits> fits_;  ///< the last answer first
  std::deque<KnownJoints> joints_;
};

}  // namespace glissade
