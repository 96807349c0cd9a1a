#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace glissade {

/// The state of a run at one time.
struct RunSample {
  double seconds = 0.0;  ///< time of planning
  double nodes = 0.0;
  double authority = 0.0;           ///< α in force
  std::optional<double> clearance;  ///< clearance of the operator's object, metres; nothing: not known
};

/// The history of a run, thinned to at most kMost samples. It always contains the latest sample.
class RunHistory {
 public:
  static constexpr std::size_t kMost = 400;

  /// Adds a sample. Another `run` clears the history. Samples that are not before this one are dropped, because a
  /// replay went back.
  void add(std::uint64_t run, const RunSample& sample);
  const std::vector<RunSample>& samples() const { return samples_; }

 private:
  void thinOut();

  std::uint64_t run_ = 0;
  double interval_ = 0.0;  ///< samples that are nearer to each other replace each other
  std::vector<RunSample> samples_;
};

}  // namespace glissade
