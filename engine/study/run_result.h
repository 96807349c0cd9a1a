#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/child_process.h"
#include "engine/base/result.h"

namespace glissade {

/// A number of a run that is the same on every machine: where `glissade-cli plan --json` has it, and
/// what the tables call it.
struct ResultColumn {
  std::string_view name;
  std::string_view pointer;  ///< JSON pointer into the report
  bool summarised;           ///< has quartiles and means in the summary
};
inline constexpr std::size_t kResultColumnCount = 27;
const std::array<ResultColumn, kResultColumnCount>& resultColumns();

/// How a run ended. The last four are the machine's answer, not the planner's.
enum class RunStatus {
  Solved,
  NoPath,
  NotCertified,  ///< a path was found, and our certificate refused it
  LimitReached,  ///< of steps or samples
  InCollision,   ///< start or goal
  Error,         ///< it ended by itself with another error
  Time,          ///< over its time limit
  Memory,        ///< over its memory limit
  Crashed        ///< ended by a signal, or without a report
};
inline constexpr std::size_t kRunStatusCount = 9;
const char* name(RunStatus status);
std::optional<RunStatus> runStatusOf(std::string_view name);

/// The status depends on the machine's speed and memory, so a repetition may end otherwise.
bool dependsOnMachine(RunStatus status);

/// What a run found: the same whenever and wherever it is run (but see dependsOnMachine).
struct RunResult {
  RunStatus status = RunStatus::Crashed;
  std::array<std::optional<double>, kResultColumnCount> numbers;  ///< as resultColumns()
  std::string certificate;                                        ///< "certified"; empty: no path
  std::string message;                                            ///< why there is no path; one line

  friend bool operator==(const RunResult&, const RunResult&) = default;
};

/// What it took on this machine.
struct RunTiming {
  std::optional<double> planningSeconds;
  std::optional<double> planningCpuSeconds;  ///< a loaded machine matters less to it
  std::optional<double> cpuSeconds;          ///< of the whole process, with loading
  double wallSeconds = 0.0;                  ///< of the whole process, with loading
  double peakMemoryMb = 0.0;
};

struct RunOutcome {
  RunResult result;
  RunTiming timing;
};

/// Reads the end of a `glissade-cli plan --json`. Never fails: what cannot be understood is Crashed.
RunOutcome outcomeOf(const ChildEnd& end, double timeLimit);

/// The file of a run (JSON), and back. `plan` is the hash of the plan that the run belongs to.
struct RunRow {
  std::string plan;
  std::size_t cell = 0;
  std::uint64_t seed = 0;
  RunOutcome outcome;
};
std::string writeRunRow(const RunRow& row);
Result<RunRow> readRunRow(const std::string& text, const std::string& file);

}  // namespace glissade
