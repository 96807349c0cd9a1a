#include "engine/session/replay_track.h"

#include <algorithm>

namespace glissade {
namespace {

/// Most rows that are kept; each takes some 200 bytes.
constexpr std::size_t kMostRows = 1U << 17;

}  // namespace

void ReplayTrack::add(std::uint64_t step, const Planner& planner) {
  const std::lock_guard lock(mutex_);
  lastStep_ = step;
  if (step % stride_ != 0) return;
  if (rows_.size() == kMostRows) {
    stride_ *= 2;
    const auto odd = [this](const Row& row) { return row.step % stride_ != 0; };
    rows_.erase(std::remove_if(rows_.begin(), rows_.end(), odd), rows_.end());
    if (step % stride_ != 0) return;
  }
  rows_.push_back({step, planner.nodes().size(), planner.edges().size(), planner.droppedEdges().size(),
                   planner.counts(), authorityOf(planner), contactModeOf(planner), coarsePlanOf(planner),
                   tuningOf(planner)});
}

ReplayTrack::Row ReplayTrack::at(std::uint64_t step) const {
  const std::lock_guard lock(mutex_);
  const auto after = std::upper_bound(rows_.begin(), rows_.end(), step,
                                      [](std::uint64_t at, const Row& row) { return at < row.step; });
  return after == rows_.begin() ? Row() : *std::prev(after);
}

std::uint64_t ReplayTrack::lastStep() const {
  const std::lock_guard lock(mutex_);
  return lastStep_;
}

std::uint64_t ReplayTrack::stride() const {
  const std::lock_guard lock(mutex_);
  return stride_;
}

}  // namespace glissade
