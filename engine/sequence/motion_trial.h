#pragma once

#include "engine/sequence/joint_removal.h"
#include "engine/sequence/searched_removal.h"
#include "engine/sequence/straight_removal.h"
#include "engine/sequence/thread_demands.h"
#include "engine/sequence/turned_removal.h"
#include "engine/sequence/two_line_removal.h"

namespace glissade {

/// Tries removals with the collision kernel and the planners. Effort 0 is straight lines and turns out of threads;
/// higher efforts are searches, after the turn where there is one, each with four times
/// the budget of the one below.
class MotionTrial final : public RemovalTrial {
 public:
  /// Largest number of search efforts.
  static constexpr int kMostSearches = 4;

  /// Refers to product, fits, rules and threads. `searches`: number of search efforts in addition to the straight
  /// lines, 0 to kMostSearches. `joints`: a group in a closed thread leaves by turning only; null: there are none.
  /// `threads`: no motion pulls them; null: there are none.
  MotionTrial(const AssembledProduct& product, const ProductFits& fits, std::uint64_t seed,
              int searches = kMostSearches, MotionWorlds::Forbidden forbidden = {}, const JointRules* joints = nullptr,
              const ThreadDemands* threads = nullptr, const Vector3& up = Vector3::UnitZ());

  int efforts() const override { return 1 + searches_; }
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop) override;
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                          const StopToken& stop) override;
  std::vector<std::size_t> inTheWay(const BodyGroup& group, const std::vector<PathPoint>& path,
                                    const std::vector<std::size_t>& left, const StopToken& stop) override;
  std::vector<Fit> fitsWith(const BodyGroup& group, const BodySet& others) const override {
    return fits_.fitsOf(group, others);
  }
  std::optional<Removed> certified(const BodyGroup& group, const std::vector<PathPoint>& path,
                                   const std::string& method, const BodySet& present, const StopToken& stop) override;
  std::vector<std::size_t> inTheWayOfTool(const MeshPtr& tool, const std::pair<Pose, Pose>& motion,
                                          const std::vector<std::size_t>& others, const StopToken& stop) override;
  void learn(const BodyGroup& group, const std::vector<PathPoint>& path) override;

 private:
  RemovalAnswer answerOf(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop);
  RemovalAnswer tryDirectly(const BodyGroup& group, const BodySet& present, const StopToken& stop);
  RemovalAnswer search(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop);
  RemovalAnswer tryTurning(const BodyGroup& group, const BodySet& present, int effort,
                           const std::vector<std::size_t>& opened, const StopToken& stop);
  RemovalAnswer searchAfterTurn(const BodyGroup& group, const BodySet& present, int effort,
                                const std::vector<std::size_t>& opened, const StopToken& stop);
  bool hasFacetsOnly(const BodyGroup& group, const std::vector<std::size_t>& opened) const;
  BodyGroup pulledOff(const BodyGroup& group, const std::vector<PathPoint>& path, const BodySet& present);
  bool keepsToBends(const BodyGroup& group, const std::vector<PathPoint>& path, const BodySet& present);

  const AssembledProduct& product_;
  const ProductFits& fits_;
  std::size_t bodies_;
  int searches_;
  MotionWorlds worlds_;
  StraightRemoval straight_;
  TurnedRemoval turned_;
  const JointRules* joints_;
  const ThreadDemands* threads_;
  TwoLineRemoval twoLines_;
  std::optional<JointRemoval> jointed_;  ///< set if there are joints
  SearchedRemoval searched_;
};

}  // namespace glissade
