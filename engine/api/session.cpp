#include <glissade/session.h>

#include "engine/api/parameter_map.h"
#include "engine/api/prepared_run.h"

namespace glissade::api {

struct Session::Impl {
  PreparedRunPtr run;

  LockstepSession& session() const { return *run->session; }
  SnapshotPtr now() const { return session().snapshot(); }
};

namespace {

template <class Task, class Impl>
Result<Session> sessionOf(const Task& task, const PlanOptions& options) {
  return attempt<Session>("beginning a run", [&]() -> Result<Session> {
    const auto run = preparedRun(task, options);
    if (!run) return run.error();
    if ((*run)->isFromOutside) return wrongArgument("strategy", "is a planner from outside, which has no steps");
    LockstepSession& session = *(*run)->session;
    session.post(command::Start{});
    session.advance(0);
    return Session(std::make_shared<Impl>(Impl{*run}));
  });
}

std::vector<std::array<std::uint32_t, 2>> publicEdges(const std::vector<RoadmapEdge>& edges) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  pairs.reserve(edges.size());
  for (const RoadmapEdge& edge : edges) pairs.push_back({edge.from, edge.to});
  return pairs;
}

}  // namespace

Result<Session> Session::make(const Problem& problem, const PlanOptions& options) {
  return sessionOf<Problem, Impl>(problem, options);
}

Result<Session> Session::make(const Scenario& scenario, const PlanOptions& options) {
  return sessionOf<Scenario, Impl>(scenario, options);
}

SessionState Session::step(std::uint64_t steps, const StopToken& stop) {
  if (state() == SessionState::Running) impl_->session().advance(steps, stop);
  return state();
}

Outcome Session::set(const Parameters& parameters) {
  const ParameterValues before = impl_->now()->parameters;
  ParameterValues after = before;
  if (auto fault = setAll(parameters, after)) return *std::move(fault);
  for (const ParameterSpec& spec : parameterTable()) {
    if (after[spec.id] != before[spec.id]) impl_->session().post(command::SetParameter{spec.id, after[spec.id]});
  }
  impl_->session().advance(0);
  return Done{};
}

SessionState Session::state() const {
  const SnapshotPtr now = impl_->now();
  if (now->problem) return SessionState::Ended;
  if (isRunning(*now)) return SessionState::Running;
  return now->path ? SessionState::Solved : SessionState::Ended;
}

std::optional<Diagnostic> Session::failure() const {
  if (state() != SessionState::Ended) return std::nullopt;
  return endOf(*impl_->run, *impl_->now()).error();
}

RunCounts Session::counts() const { return publicCounts(impl_->now()->counts); }

Parameters Session::parameters() const { return publicParameters(impl_->now()->parameters); }

Pose Session::hand() const { return publicPose(impl_->now()->device.q_device); }

Roadmap Session::roadmap() const {
  const SnapshotPtr now = impl_->now();
  Roadmap roadmap;
  for (const auto& chunk : now->roadmap) {
    for (const RoadmapNode& node : chunk->nodes) {
      roadmap.nodes.push_back(publicPose(node.q));
      roadmap.authors.push_back(static_cast<Author>(node.author));
      roadmap.trees.push_back(static_cast<Tree>(node.side));
    }
    const auto edges = publicEdges(chunk->edges);
    roadmap.edges.insert(roadmap.edges.end(), edges.begin(), edges.end());
  }
  roadmap.dropped = publicEdges(now->droppedEdges);
  return roadmap;
}

std::optional<Path> Session::path() const {
  if (state() != SessionState::Solved) return std::nullopt;
  return endOf(*impl_->run, *impl_->now()).value();
}

}  // namespace glissade::api
