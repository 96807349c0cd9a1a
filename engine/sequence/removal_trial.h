#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/planning/path.h"
#include "engine/sequence/product_fits.h"

namespace glissade {

/// A certified motion that takes a group out of the product.
struct Removed {
  Path path;              ///< path of MovingObject's frame; the certificate names bodies by their index in the product
  std::string method;     ///< see StepMotion::method
  std::vector<Fit> fits;  ///< fits with bodies that were there
};

/// No motion was found.
struct Refused {
  /// Indices of blocking bodies, ascending. While all of them are there, the same trial with the same effort gives the
  /// same answer, or for searches an answer as likely.
  std::vector<std::size_t> blockedBy;
  bool stopped = false;  ///< the answer is not final
};

using RemovalAnswer = std::variant<Removed, Refused>;

/// The question of RemovalTrial::groupsAlongLines().
struct GroupQuestion {
  const BodySet& present;
  const BodySet& staying;               ///< bodies that are not to leave
  const std::vector<BodyGroup>& units;  ///< all bodies that are there, as units that only leave together
  std::size_t most = 0;                 ///< largest number of bodies of a group
};

/// Answers whether bodies can leave.
class RemovalTrial {
 public:
  virtual ~RemovalTrial() = default;

  /// How many levels of effort there are, at least 1.
  virtual int efforts() const = 0;
  /// Tries to remove the group as one rigid body while the bodies of `present`, which contains the group, are there.
  /// The answer depends on group, set, effort and what was learned, never on other calls. May be called from several
  /// threads at a time, for groups that have no body in common.
  virtual RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort,
                                   const StopToken& stop) = 0;
  /// Groups of several units that can leave along a straight line, without common bodies, the smallest first; no part
  /// of such a group can leave along its line. After a stop the answer is empty.
  virtual std::vector<BodyGroup> groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                                  const StopToken& stop) = 0;
  /// The bodies of `left` that would block the motion if they were there; ascending. May be called from several threads
  /// at a time.
  virtual std::vector<std::size_t> inTheWay(const BodyGroup& group, const std::vector<PathPoint>& path,
                                            const std::vector<std::size_t>& left, const StopToken& stop) = 0;
  /// The fits of the group with bodies of `others`.
  virtual std::vector<Fit> fitsWith(const BodyGroup& /*group*/, const BodySet& /*others*/) const { return {}; }
  /// The motion, certified while the bodies of `present` are there; nothing if it is not certified. Same threads as
  /// tryRemoval().
  virtual std::optional<Removed> certified(const BodyGroup& group, const std::vector<PathPoint>& path,
                                           const std::string& method, const BodySet& present,
                                           const StopToken& stop) = 0;
  /// The bodies of `others` that block a tool on the straight motion between the two configurations, ascending. May be
  /// called from several threads at a time.
  virtual std::vector<std::size_t> inTheWayOfTool(const MeshPtr& /*tool*/, const std::pair<Pose, Pose>& /*motion*/,
                                                  const std::vector<std::size_t>& /*others*/,
                                                  const StopToken& /*stop*/) {
    return {};
  }
  /// Learns the path by which a group has left. Not called while other calls run.
  virtual void learn(const BodyGroup& group, const std::vector<PathPoint>& path) = 0;
};

}  // namespace glissade
