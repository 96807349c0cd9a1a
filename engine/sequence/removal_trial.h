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
  Path path;                  ///< of MovingObject's frame; the certificate names bodies by their index in the product
  std::string method;         ///< as of AssemblyStep
  std::vector<BodyFit> fits;  ///< with bodies that were there
};

/// No motion was found.
struct Refused {
  /// Indices of bodies that were in the way, ascending: asked again with the same effort while all of them are there,
  /// the answer is the same, or as likely to be (of searches).
  std::vector<std::size_t> blockedBy;
  bool stopped = false;  ///< the answer is not final
};

using RemovalAnswer = std::variant<Removed, Refused>;

/// What may leave together: see RemovalTrial::groupsAlongLines().
struct GroupQuestion {
  const BodySet& present;
  const BodySet& staying;               ///< bodies that are not to leave
  const std::vector<BodyGroup>& units;  ///< all bodies that are there, those that only leave together in one
  std::size_t most = 0;                 ///< bodies of a group
};

/// Answers whether bodies can leave.
class RemovalTrial {
 public:
  virtual ~RemovalTrial() = default;

  /// How many levels of effort there are, at least 1.
  virtual int efforts() const = 0;
  /// The group leaves as one rigid body while those of `present` are there, which has the group itself. The answer
  /// depends on group, set, effort and what was learned, never on other calls. May be called from several threads at
  /// a time, for groups that have no body in common.
  virtual RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort,
                                   const StopToken& stop) = 0;
  /// Groups of several units that can leave along a straight line, no two with a body in common, the smallest first;
  /// no part of such a group can leave along its line. After a stop the answer is empty.
  virtual std::vector<BodyGroup> groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                                  const StopToken& stop) = 0;
  /// Bodies of `left` that would be in the way of the motion, if they were there; ascending. May be called from
  /// several threads at a time.
  virtual std::vector<std::size_t> inTheWay(const BodyGroup& group, const std::vector<PathPoint>& path,
                                            const std::vector<std::size_t>& left, const StopToken& stop) = 0;
  /// How the group is taken against those of `others` that it fits.
  virtual std::vector<BodyFit> fitsWith(const BodyGroup& /*group*/, const BodySet& /*others*/) const { return {}; }
  /// The motion certified while those of `present` are there; nothing where it is not. May be called as tryRemoval().
  virtual std::optional<Removed> certified(const BodyGroup& group, const std::vector<PathPoint>& path,
                                           const std::string& method, const BodySet& present,
                                           const StopToken& stop) = 0;
  /// Bodies of `others` that are in the way of a tool on the straight motion between the two configurations, ascending.
  /// May be called from several threads at a time.
  virtual std::vector<std::size_t> inTheWayOfTool(const MeshPtr& /*tool*/, const std::pair<Pose, Pose>& /*motion*/,
                                                  const std::vector<std::size_t>& /*others*/,
                                                  const StopToken& /*stop*/) {
    return {};
  }
  /// A group has left so. Not while others ask.
  virtual void learn(const BodyGroup& group, const std::vector<PathPoint>& path) = 0;
};

}  // namespace glissade
