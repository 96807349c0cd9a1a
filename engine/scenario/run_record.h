#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/base/result.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Everything that it takes to run an interactive session again and get the same roadmap, bit by bit
/// (DESIGN section 5). Steps are planner steps, counted from 0.
struct RunRecord {
  struct File {
    std::string path;    ///< scenario: as given; assets: relative to the scenario's folder
    std::string sha256;  ///< of the content
  };
  struct ParameterChange {
    std::uint64_t step = 0;  ///< in force from this step on
    ParameterId id = ParameterId::Alpha;
    double value = 0.0;
  };
  struct OperatorPose {
    std::uint64_t step = 0;  ///< the planner saw q_device from this step on
    Pose q_device;
  };
  /// How the run ended, to compare a replay with.
  struct Ending {
    std::string status;  ///< as the command line reports it: "solved", "limit reached", ...
    std::uint64_t steps = 0;
    std::uint64_t iterations = 0;
    std::uint64_t nodes = 0;
    std::uint64_t edges = 0;
    std::uint64_t randomConfigurations = 0;
    std::uint64_t operatorConfigurations = 0;
    std::uint64_t contactConfigurations = 0;
  };

  std::string program;  ///< the version of Glissade that wrote it
  File scenario;
  std::vector<File> assets;
  std::string planner;
  std::uint64_t seed = 1;
  std::map<ParameterId, double> parameters;  ///< at step 0; all of them
  std::vector<ParameterChange> changes;      ///< in order of steps
  std::vector<OperatorPose> operatorStream;  ///< in order of steps; empty: no operator
  Ending ending;
};

/// Canonical JSON; doubles read back bit-equal.
std::string writeRunRecord(const RunRecord& record);
/// Strict, as parseScenario: MalformedInput with the JSON pointer as place.
Result<RunRecord> parseRunRecord(const std::string& text, const std::string& file);

/// Saves atomically.
Outcome saveRunRecord(const RunRecord& record, const std::string& file);
Result<RunRecord> loadRunRecord(const std::string& file);

}  // namespace glissade
