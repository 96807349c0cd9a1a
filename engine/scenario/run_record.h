#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/operator/recorded_device.h"
#include "engine/scenario/scenario.h"

namespace glissade {

/// One run as a file: enough to grow the same roadmap again, bit by bit, also where a person steered.
struct RunRecord {
  struct ParameterChange {
    std::uint64_t step = 0;
    ParameterId id = ParameterId::Alpha;
    double value = 0.0;
  };

  std::string scenario;        ///< file as the user named it
  std::string scenarioSha256;  ///< of the canonical scenario with its asset hashes
  std::string planner;
  std::uint64_t seed = 1;
  std::map<ParameterId, double> parameters;  ///< all of them, at the start
  std::vector<ParameterChange> parameterChanges;
  std::vector<RecordedPose> operatorStream;
  bool hadOperator = false;
  std::uint64_t nodes = 0;  ///< at the end, to compare a replay with
};

/// Saved atomically.
Outcome writeRunRecord(const RunRecord& record, const std::string& file);
Result<RunRecord> readRunRecord(const std::string& file);

}  // namespace glissade
