#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace glissade {

/// A run at one moment.
struct RunSample {
  double seconds = 0.0;  ///< of planning
  double nodes = 0.0;
  double authority = 0.0;           ///< α in force
  std::optional<double> clearance;  ///< of the object in the operator's hand, metres; nothing: not known
};

/// What a run has been like so far, thinned so that it never has more than kMost samples. The latest is always there.
class RunHistory {
 public:
  static constexpr std::size_t kMost = 400;

  /// Another `run` begins anew. Samples that are later than this one are dropped: a replay went back.
  void add(std::uint64_t run, const RunSample& sample);
  const std::vector<RunSample>& samples() const { return samples_; }

 private:
  void thinOut();

  std::uint64_t run_ = 0;
  double interval_ = 0.0;  ///< samples that are nearer to each other than this replace each other
  std::vector<RunSample> samples_;
};

}  // namespace glissade
