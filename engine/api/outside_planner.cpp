#include "engine/api/outside_planner.h"

#include <limits>

#include "engine/api/values.h"
#include "engine/planning/path_examination.h"

namespace glissade::api {
namespace {

/// Calls a function once and certifies its path. It has no roadmap. A session must not divide its run into slices,
/// because a function cannot go on where it has returned.
class OutsidePlanner final : public Planner {
 public:
  OutsidePlanner(PlannerFunction search, const glissade::Problem& problem, std::uint64_t seed)
      : search_(std::move(search)), problem_(problem), seed_(seed), query_(valueOf<World>({problem.world}).query()) {}

  bool solve(PlannerHost& host) override;

  const std::vector<RoadmapNode>& nodes() const override { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const glissade::Path* path() const override { return path_ ? &*path_ : nullptr; }
  std::optional<glissade::Diagnostic> failure() const override { return failure_; }

 private:
  class Context;

  void deliver(const std::vector<Pose>& way, PlannerHost& host);
  void giveUp(std::string reason) {
    failure_ = glissade::Diagnostic{ErrorKind::NoPath, "", "", Message(std::move(reason)), {}};
  }

  PlannerFunction search_;
  glissade::Problem problem_;
  std::uint64_t seed_;
  Query query_;
  bool asked_ = false;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  PlannerCounts counts_;
  std::optional<glissade::Path> path_;
  std::optional<glissade::Diagnostic> failure_;
};

class OutsidePlanner::Context final : public PlannerContext {
 public:
  Context(OutsidePlanner& planner, PlannerHost& host)
      : planner_(planner), host_(host), problem_(valueOf<Problem>({planner.problem_, host.parameters()})) {}

  const Problem& problem() const override { return problem_; }
  Query& query() override { return planner_.query_; }
  std::uint64_t seed() const override { return planner_.seed_; }
  double parameter(const std::string& key) const override {
    const auto id = parameterByKey(key);
    return id ? host_.parameters()[*id] : std::numeric_limits<double>::quiet_NaN();
  }
  bool step() override {
    ++planner_.counts_.iterations;
    ++planner_.counts_.steps;
    ++planner_.counts_.randomConfigurations;
    planner_.counts_.queries = planner_.query_.impl().query->counts();
    goesOn_ = goesOn_ && host_.afterStep();
    return goesOn_;
  }
  bool ended() const { return !goesOn_; }

 private:
  OutsidePlanner& planner_;
  PlannerHost& host_;
  Problem problem_;
  bool goesOn_ = true;
};

bool OutsidePlanner::solve(PlannerHost& host) {
  if (asked_) {
    giveUp("the planner has ended before it found a path");
    return false;
  }
  asked_ = true;
  Context context(*this, host);
  const std::vector<Pose> way = search_(context);
  if (way.empty()) {
    // The session states the limit or the stop that ended the run.
    if (!context.ended()) giveUp("the planner has found no path");
    return false;
  }
  deliver(way, host);
  return path_.has_value();
}

void OutsidePlanner::deliver(const std::vector<Pose>& way, PlannerHost& host) {
  if (const auto fault = faultOfPoses(way, "path")) return giveUp("the planner's " + fault->text());
  std::vector<PathPoint> points;
  for (const Pose& q : way) points.push_back({enginePose(q)});
  PathExamination examined =
      examinePath(withUnitRotations(std::move(points)), problem_, host.parameters(), host.stopToken());
  if (!examined.ends.start) return giveUp("the planner's path does not begin at the start");
  if (!examined.ends.goal) return giveUp("the planner's path does not end at the goal");
  if (!examined.complete) return;
  if (!examined.holds()) {
    ++counts_.rejectedPaths;
    return giveUp("the planner's path is not certified: edge " + std::to_string(examined.blocked.front().edge) +
                  " does not keep the clearance, or leaves the bounds");
  }
  path_ = std::move(examined.path);
}

}  // namespace

PlannerEntry entryOf(const Planners::Entry& outside) {
  PlannerEntry entry;
  entry.id = outside.id;
  entry.label = Message(outside.id);
  entry.description = Message(outside.id);
  entry.complete = false;
  entry.make = [search = outside.search](const glissade::Problem& problem, std::uint64_t seed) {
    return std::make_unique<OutsidePlanner>(search, problem, seed);
  };
  return entry;
}

}  // namespace glissade::api
