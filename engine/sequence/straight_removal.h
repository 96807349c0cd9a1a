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

/// Removal along straight lines. Whether a body blocks a line of another body depends on these two only, and is found
/// at most once: the lines form the blocking graph of the product, whose edges are computed on demand. The answer
/// therefore holds in every order of removals. A group leaves along a line if no body outside of it blocks the line of
/// one of its bodies; the smallest such group contains all bodies that can be reached in the graph (Wilson and Latombe
/// 1994).
class StraightRemoval {
 public:
  /// Refers to all arguments but `up`, the upward direction of the work place, unit. `threads`: no line pulls them;
  /// null: there are none.
  StraightRemoval(const AssembledProduct& product, const ProductFits& fits, MotionWorlds& worlds,
                  const ThreadDemands* threads, const Vector3& up);

  /// See RemovalTrial::tryRemoval(). The answer is the free line on which the group slides least along what it touches.
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop);
  /// See RemovalTrial::groupsAlongLines(). `links`: pairs of present bodies; the second one leaves only together with
  /// the first one.
  std::vector<BodyGroup> groups(const GroupQuestion& question,
                                const std::vector<std::pair<std::size_t, std::size_t>>& links, ThreadTeam& team,
                                const StopToken& stop);
  /// Bodies of the same geometry will try this path's direction first.
  void learn(const BodyGroup& group, const std::vector<PathPoint>& path);

 private:
  enum class Blocking : unsigned char { Unknown, No, Yes };
  /// A line of a body, and the bodies that block it.
  struct Line {
    Vector3 direction;
    Vector3 way;  ///< displacement that moves the body out of the bounding box of all others
    Box3 swept;   ///< box that contains the body along the whole line
    std::vector<std::atomic<Blocking>> blockedBy;  ///< set by any thread
  };
  struct Lines {
    bool known = false;
    Box3 others;                     ///< box of all other bodies
    std::size_t own = 0;             ///< number of leading `lines` that are tried; the others were added for groups
    std::deque<Line> lines;          ///< never moved
    std::vector<std::size_t> order;  ///< other bodies, those with a fit first
  };
  Lines& linesOf(std::size_t body);
  Line& lineAlong(std::size_t body, const Vector3& direction);
  Line newLine(std::size_t body, const Box3& others, const Vector3& direction) const;
  std::vector<Vector3> directionsOf(const BodyGroup& group);
  void sortBySlide(const BodyGroup& group, const BodySet& others, std::vector<Vector3>& directions);
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
  Vector3 up_;
  std::vector<Lines> lines_;            ///< one entry for each body
  std::map<MeshPtr, Vector3> learned_;  ///< last exit direction of each mesh, in the body's frame
};

}  // namespace glissade
