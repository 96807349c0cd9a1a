#pragma once

#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Forwards every question to another trial, to which it refers. A derived class overrides the questions that it
/// answers.
class ForwardingTrial : public RemovalTrial {
 public:
  explicit ForwardingTrial(RemovalTrial& inner) : inner_(inner) {}

  int efforts() const override { return inner_.efforts(); }
  RemovalAnswer tryRemoval(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop) override {
    return inner_.tryRemoval(group, present, effort, stop);
  }
  std::vector<BodyGroup> groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                          const StopToken& stop) override {
    return inner_.groupsAlongLines(question, team, stop);
  }
  std::vector<std::size_t> inTheWay(const BodyGroup& group, const std::vector<PathPoint>& path,
                                    const std::vector<std::size_t>& left, const StopToken& stop) override {
    return inner_.inTheWay(group, path, left, stop);
  }
  std::vector<Fit> fitsWith(const BodyGroup& group, const BodySet& others) const override {
    return inner_.fitsWith(group, others);
  }
  std::optional<Removed> certified(const BodyGroup& group, const std::vector<PathPoint>& path,
                                   const std::string& method, const BodySet& present, const StopToken& stop) override {
    return inner_.certified(group, path, method, present, stop);
  }
  std::vector<std::size_t> inTheWayOfTool(const MeshPtr& tool, const std::pair<Pose, Pose>& motion,
                                          const std::vector<std::size_t>& others, const StopToken& stop) override {
    return inner_.inTheWayOfTool(tool, motion, others, stop);
  }
  void learn(const BodyGroup& group, const std::vector<PathPoint>& path) override { inner_.learn(group, path); }

 protected:
  RemovalTrial& inner() { return inner_; }

 private:
  RemovalTrial& inner_;
};

}  // namespace glissade
