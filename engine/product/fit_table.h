#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "engine/base/thread_team.h"
#include "engine/product/object_fits.h"

namespace glissade {

/// What a pair means for planning.
enum class FitStatus {
  Clear,     ///< apart, or taken as they are
  Allowed,   ///< one body or both are taken thinner against each other
  Accepted,  ///< a clash that a person has accepted: allowed, too
  Clash      ///< an overlap that stops a motion of either body
};

/// "clear", "allowed", "accepted", "clash"
const char* statusName(FitStatus status);

/// How a pair is taken while one of its bodies moves past the other.
struct PairWay {
  std::vector<Fit> taken{};  ///< the body that gives way, or both; none: both are whole
  std::string refused{};     ///< why no motion passes, for people; empty: it does

  /// Metres, the larger of both; 0 where nothing is taken thinner.
  double allowance() const;
};

/// Two bodies of a product that are near each other, and what becomes of them.
struct PairFit {
  std::string a;  ///< id of the body; of the lower index
  std::string b;
  std::array<std::string, 2> shown;  ///< what people see of the names
  Contact contact;                   ///< with the kind and the overlap that count; indices in the product
  /// While `a` moves past `b`, and while `b` moves past `a`. The same body gives way, by more where the one that moves
  /// is larger (assembledGap()).
  std::array<PairWay, 2> ways{};
  bool givesWayFirstIsA = true;  ///< givesWayFirst()

  /// The way of the smaller body: it is the one that moves more often.
  const PairWay& way() const { return ways[givesWayFirstIsA ? 0 : 1]; }
  FitStatus status() const;
  /// Ids of the bodies that are taken thinner on this way.
  std::vector<std::string> thinner() const;
};

/// The one table of a product's fits: what fits, plans, sequences and the window take a pair to be. Immutable, shared
/// by threads.
class FitTable {
 public:
  /// Compares each pair of bodies once, whether the product's fits are on or not. `watch` is told the share that is
  /// done, by one thread at a time. Errors: as of findObjectFits(); Interrupted.
  static Result<FitTable> find(const AssembledProduct& product, ThreadTeam& team, const WorkWatch& watch,
                               const ContactLimits& limits = {});

  /// Pairs that touch, overlap or are nearer than was asked for, by a, then by b.
  const std::vector<PairFit>& pairs() const { return pairs_; }
  /// Of each body with others, while it moves.
  const std::vector<ObjectFits>& objects() const { return objects_; }
  /// Clashes, each once, and plain overlaps.
  const Warnings& warnings() const { return warnings_; }
  /// What the worlds of the product's motions are made of, with the thinned bodies in it.
  const std::shared_ptr<PreparedBodies>& prepared() const { return prepared_; }

 private:
  void addPairs(const AssembledProduct& product);

  std::vector<PairFit> pairs_;
  std::vector<ObjectFits> objects_;
  Warnings warnings_;
  std::shared_ptr<PreparedBodies> prepared_;
};

/// Pairs that overlap without being a fit, a thread or a press, as a warning that lists the first of them; none: no
/// pair does.
Warnings warningsOfPlainOverlaps(const std::vector<PairFit>& fits);

/// How many pairs there are of each kind, by the name of the kind.
std::map<std::string, int> countsByKind(const std::vector<PairFit>& fits);

}  // namespace glissade
