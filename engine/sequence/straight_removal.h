#pragma once

#include <atomic>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_trial.h"
#include "engine/sequence/thread_demands.h"

namespace glissade {

/// Removal along straight lines. Whether a body blocks a line of another one is a fact about the two, found at most
/// once: the blocking graph of the product for these lines, filled where it is asked. So an answer holds whoever else
/// leaves. A group leaves along a line where nobody outside of it blocks the line of one of its bodies: the smallest
/// group is all that can be reached in the graph (Wilson and Latombe 1994).
class StraightRemoval {
 public:
  /// Refers to all. `threads`: no line pulls them; null: there are none.
  StraightRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds,
                  const ThreadDemands* threads);

  /// As RemovalTrial::tryRemoval().
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop);
  /// As RemovalTrial::groupsAlongLines(). `links`: pairs of bodies that are there; the second one does not leave unless
  /// the first one does.
  std::vector<BodyGroup> groups(const GroupQuestion& question,
                                const std::vector<std::pair<std::size_t, std::size_t>>& links, ThreadTeam& team,
                                const StopToken& stop);
  /// Bodies of the same geometry try the line of this one first.
  void learn(const BodyGroup& group, const std::vector<PathPoint>& path);

 private:
  enum class Blocking : unsigned char { Unknown, No, Yes };
  /// A line of a body, and who blocks it.
  struct Line {
    Vector3 direction;
    Vector3 way;                                   ///< until the body is out of the bounding box of all others
    Box3 swept;                                    ///< holds the body on all of the line
    std::vector<std::atomic<Blocking>> blockedBy;  ///< set by any thread
  };
  struct Lines {
    bool known = false;
    Box3 others;                     ///< of all other bodies
    std::size_t own = 0;             ///< the first of `lines`, which are tried; the others were asked for by groups
    std::deque<Line> lines;          ///< never moved
    std::vector<std::size_t> order;  ///< others, those that it fits first
  };
  Lines& linesOf(std::size_t body);
  Line& lineAlong(std::size_t body, const Vector3& direction);
  Line newLine(std::size_t body, const Box3& others, const Vector3& direction) const;
  std::vector<Vector3> directionsOf(const BodyGroup& group);
  std::optional<std::size_t> blockerOf(const BodyGroup& group, const Vector3& direction, const BodySet& others,
                                       const StopToken& stop);
  std::optional<std::size_t> blockerOf(std::size_t body, Line& line, const BodySet& others, const StopToken& stop);
  std::vector<BodyGroup> groupsAlong(const Vector3& direction, const GroupQuestion& question,
                                     const std::set<std::pair<std::size_t, std::size_t>>& linked,
                                     const StopToken& stop);
  bool isBlocking(std::size_t other, std::size_t body, Line& line, const StopToken& stop);
  Path certified(const BodyGroup& group, const Vector3& direction, const BodySet& present, const StopToken& stop);

  const AssembledProduct& product_;
  const ProductFits& fits_;
  MotionWorlds& worlds_;
  const ThreadDemands* threads_;
  std::vector<Lines> lines_;            ///< of each body
  std::map<MeshPtr, Vector3> learned_;  ///< in the body's frame, the last one
};

}  // namespace glissade
