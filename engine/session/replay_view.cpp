#include "engine/session/replay_view.h"

#include <algorithm>
#include <limits>

namespace glissade {
namespace {

/// Number of runs in a replay's snapshots. No session reaches it, so that a replay is never mistaken for a run.
constexpr std::uint64_t kReplayRuns = std::numeric_limits<std::uint64_t>::max();

ParameterValues parametersAt(const RunLog& log, std::uint64_t step) {
  ParameterValues parameters = log.start.parameters;
  for (const RunLog::ParameterChange& change : log.parameterChanges) {
    if (change.step > step) break;
    (void)parameters.set(change.id, change.value);  // the value was checked when the record was read
  }
  return parameters;
}

}  // namespace

RoadmapChunks roadmapPrefix(const RoadmapChunks& chunks, std::size_t nodes, std::size_t edges) {
  RoadmapChunks prefix;
  for (const auto& chunk : chunks) {
    if (nodes == 0 && edges == 0) break;
    const std::size_t someNodes = std::min(nodes, chunk->nodes.size());
    const std::size_t someEdges = std::min(edges, chunk->edges.size());
    if (someNodes == chunk->nodes.size() && someEdges == chunk->edges.size()) {
      prefix.push_back(chunk);
    } else {
      auto cut = std::make_shared<RoadmapChunk>();
      cut->nodes.assign(chunk->nodes.begin(), chunk->nodes.begin() + static_cast<std::ptrdiff_t>(someNodes));
      cut->edges.assign(chunk->edges.begin(), chunk->edges.begin() + static_cast<std::ptrdiff_t>(someEdges));
      prefix.push_back(std::move(cut));
    }
    nodes -= someNodes;
    edges -= someEdges;
  }
  return prefix;
}

ReplayView::ReplayView(const Problem& problem, std::shared_ptr<const RunLog> log,
                       std::shared_ptr<const ReplayTrack> track, std::uint64_t number)
    : start_(problem.start),
      query_(problem.world->makeQuery()),
      log_(std::move(log)),
      track_(std::move(track)),
      run_(kReplayRuns - number) {}

SnapshotPtr ReplayView::at(std::uint64_t step, const SessionSnapshot& latest, bool end) {
  const ReplayTrack::Row row = track_->at(step);
  auto snapshot = std::make_shared<SessionSnapshot>();
  snapshot->revision = ++revision_;
  snapshot->run = run_;
  snapshot->state = end ? latest.state : SessionState::Planning;
  if (end) snapshot->path = latest.path;
  if (end) snapshot->problem = latest.problem;
  snapshot->plannerId = log_->start.planner;
  snapshot->seed = log_->start.seed;
  snapshot->parameters = parametersAt(*log_, step);
  snapshot->counts = row.counts;
  snapshot->virtualSeconds = snapshot->planningSeconds = secondsAt(*log_, step);
  snapshot->authority = row.authority;
  snapshot->contactMode = row.contactMode;
  snapshot->coarsePlan = row.coarsePlan;
  snapshot->tuning = row.tuning;
  snapshot->roadmap = roadmapPrefix(latest.roadmap, row.nodes, row.edges);
  for (const auto& chunk : snapshot->roadmap) {
    for (const RoadmapNode& node : chunk->nodes) ++snapshot->nodesByAuthor[static_cast<std::size_t>(node.author)];
  }
  const auto dropped = static_cast<std::ptrdiff_t>(std::min(row.droppedEdges, latest.droppedEdges.size()));
  snapshot->droppedEdges.assign(latest.droppedEdges.begin(), latest.droppedEdges.begin() + dropped);
  placeHand(step, *snapshot);
  return snapshot;
}

void ReplayView::placeHand(std::uint64_t step, SessionSnapshot& snapshot) const {
  const auto& stream = log_->operatorStream;
  auto entry = std::upper_bound(stream.begin(), stream.end(), step,
                                [](std::uint64_t at, const RunLog::HandPose& pose) { return at < pose.step; });
  // The object stays where somebody released it.
  while (entry != stream.begin() && !std::prev(entry)->q_device) --entry;
  snapshot.device.q_device = entry == stream.begin() ? start_ : *std::prev(entry)->q_device;
  snapshot.device.moves = static_cast<std::uint64_t>(std::distance(stream.begin(), entry));
  snapshot.device.nearest = query_->nearestObstacle(snapshot.device.q_device);
}

}  // namespace glissade
