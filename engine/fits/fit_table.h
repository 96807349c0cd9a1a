#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/message.h"
#include "engine/base/thread_team.h"
#include "engine/fits/object_fits.h"
#include "engine/model/body_id.h"

namespace glissade {

/// The meaning of a pair for planning.
enum class FitStatus {
  Clear,     ///< apart, or without allowance
  Allowed,   ///< one body or both are thinned
  Accepted,  ///< a clash that a person accepts; it is also allowed
  Clash      ///< an overlap that blocks every motion of either body
};

inline constexpr EnumNames<FitStatus, 4> kFitStatusNames{{"clear", "allowed", "accepted", "clash"}};

/// The shapes of a pair while one of its bodies moves past the other.
struct PairWay {
  std::vector<Fit> taken{};  ///< the thinned body, or both; none: both are whole
  Message refused{};         ///< reason why no motion passes; empty: motions pass

  /// The larger allowance of the two bodies, metres; 0 if neither is thinned.
  double allowance() const;
};

/// Two bodies of a product that are near each other, with their fit.
struct PairFit {
  BodyId a;  ///< id of the body with the lower index
  BodyId b;
  std::array<std::string, 2> shown;  ///< names for people
  Contact contact;                   ///< with the kind and the overlap that count; indices in the product
  /// While `a` moves past `b`, and while `b` moves past `a`. The same body is thinned in both, by more if the moving
  /// body is larger (assembledGap()).
  std::array<PairWay, 2> ways{};
  bool givesWayFirstIsA = true;  ///< givesWayFirst()

  /// The fit while the smaller body moves, which is the more frequent case.
  const PairWay& way() const { return ways[givesWayFirstIsA ? 0 : 1]; }
  FitStatus status() const;
  /// Ids of the bodies that are thinned in way().
  std::vector<BodyId> thinner() const;
};

/// When the search for fits ends although pairs are left.
struct FitDeadlines {
  StopToken contacts;  ///< no other pair is looked at for contacts
  StopToken pairs;     ///< no other pair is measured
};

/// The table of a product's fits that plans, sequences and the window share. Immutable, shared by threads.
class FitTable {
 public:
  /// Compares each pair of bodies once, whether the product's fits are on or not. `watch` gets the finished share, from
  /// one thread at a time. After the deadlines the table lacks the pairs of notCompared(), whose bodies have no
  /// allowance against each other. Errors: see findObjectFits(); Interrupted.
  static Result<FitTable> find(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch,
                               const ContactLimits& limits = {}, const std::optional<FitDeadlines>& deadlines = {});

  /// The table of a product whose fits were found before: `objects` are those of a table of the same product.
  static FitTable of(const AssembledProduct& product, std::vector<ObjectFits> objects);

  /// The table of a product without fits: each body is whole, and no pair is compared.
  static FitTable whole(const AssembledProduct& product);

  /// Pairs that touch, overlap or are within the requested clearance, by a, then by b.
  const std::vector<PairFit>& pairs() const { return pairs_; }
  /// The fits of each body with others while it moves.
  const std::vector<ObjectFits>& objects() const { return objects_; }
  /// Clashes and plain overlaps, each pair once.
  const Warnings& warnings() const { return warnings_; }
  /// Pairs of bodies, by index, that deadlines have left.
  const std::set<std::pair<std::size_t, std::size_t>>& notCompared() const { return notCompared_; }
  /// Collision bodies for the product's motions, with the thinned bodies.
  const std::shared_ptr<PreparedBodies>& prepared() const { return prepared_; }

 private:
  FitTable(const AssembledProduct& product, std::vector<ObjectFits> objects);
  void addPairs(const AssembledProduct& product);

  std::vector<PairFit> pairs_;
  std::vector<ObjectFits> objects_;
  Warnings warnings_;
  std::shared_ptr<PreparedBodies> prepared_;
  std::set<std::pair<std::size_t, std::size_t>> notCompared_;
};

using FitTablePtr = std::shared_ptr<const FitTable>;

/// A warning that lists the first pairs that overlap without being a fit, a thread or a press; none if there is no such
/// pair.
Warnings warningsOfPlainOverlaps(const std::vector<PairFit>& fits);

/// The number of pairs of each kind, by the name of the kind.
std::map<std::string, int> countsByKind(const std::vector<PairFit>& fits);

}  // namespace glissade
