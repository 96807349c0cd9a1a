#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/child_process.h"
#include "engine/base/enum_names.h"
#include "engine/base/result.h"

namespace glissade {

/// A number of a run that is the same on every machine: its place in `glissade-cli plan --json`, and its name in the
/// tables.
struct ResultColumn {
  std::string_view name;
  std::string_view pointer;  ///< JSON pointer into the report
  bool summarised;           ///< has quartiles and means in the summary
};
inline constexpr std::size_t kResultColumnCount = 27;
const std::array<ResultColumn, kResultColumnCount>& resultColumns();

/// End of a run. The last four depend on the machine or the program, not on the planner.
enum class RunStatus {
  Solved,
  NoPath,
  NotCertified,  ///< a path was found but not certified
  LimitReached,  ///< a limit of steps or samples
  InCollision,   ///< start or goal in collision
  Error,         ///< the run ended by itself with another error
  Time,          ///< over the time limit
  Memory,        ///< over the memory limit
  Crashed        ///< ended by a signal, or without a report
};
inline constexpr std::size_t kRunStatusCount = 9;
inline constexpr EnumNames<RunStatus, kRunStatusCount> kRunStatusNames{
    {"solved", "no-path", "not-certified", "limit-reached", "in-collision", "error", "time", "memory", "crashed"}};

/// True if the status depends on the machine's speed and memory, so that a repetition may end otherwise.
bool dependsOnMachine(RunStatus status);

/// The result of a run, which is the same on every machine (except dependsOnMachine()).
struct RunResult {
  RunStatus status = RunStatus::Crashed;
  std::array<std::optional<double>, kResultColumnCount> numbers;  ///< in the order of resultColumns()
  std::string certificate;                                        ///< "certified"; empty: no path
  std::string message;                                            ///< reason why there is no path; one line

  friend bool operator==(const RunResult&, const RunResult&) = default;
};

/// Cost of a run on this machine.
struct RunTiming {
  std::optional<double> planningSeconds;
  std::optional<double> planningCpuSeconds;  ///< depends less on the load of the machine
  std::optional<double> cpuSeconds;          ///< time of the whole process, with loading
  double wallSeconds = 0.0;                  ///< time of the whole process, with loading
  double peakMemoryMb = 0.0;
};

struct RunOutcome {
  RunResult result;
  RunTiming timing;
};

/// Reads the output of a `glissade-cli plan --json` that has ended. Never fails: malformed output is Crashed.
RunOutcome outcomeOf(const ChildEnd& end, double timeLimit);

/// The file of a run (JSON), to and from text. `plan`: hash of the plan to which the run belongs.
struct RunRow {
  std::string plan;
  std::size_t cell = 0;
  std::uint64_t seed = 0;
  RunOutcome outcome;
};
std::string writeRunRow(const RunRow& row);
Result<RunRow> readRunRow(const std::string& text, const std::string& file);

}  // namespace glissade
