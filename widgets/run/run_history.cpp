#include "widgets/run/run_history.h"

namespace glissade {

void RunHistory::add(std::uint64_t run, const RunSample& sample) {
  if (run != run_) {
    samples_.clear();
    interval_ = 0.0;
    run_ = run;
  }
  while (!samples_.empty() && samples_.back().seconds >= sample.seconds) samples_.pop_back();
  const std::size_t count = samples_.size();
  if (count >= 2 && sample.seconds - samples_[count - 2].seconds < interval_) samples_.pop_back();
  samples_.push_back(sample);
  if (samples_.size() > kMost) thinOut();
}

/// Keeps every second sample and the latest.
void RunHistory::thinOut() {
  const RunSample latest = samples_.back();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples_.size(); i += 2) samples_[kept++] = samples_[i];
  samples_.resize(kept);
  if (samples_.back().seconds < latest.seconds) samples_.push_back(latest);
  interval_ = 2.0 * (latest.seconds - samples_.front().seconds) / static_cast<double>(kMost);
}

}  // namespace glissade
