#include "tests/ratchet/work_cases.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/base/child_process.h"
#include "engine/base/file.h"

namespace glissade::ratchet {
namespace {

using Json = nlohmann::json;

constexpr const char* kResult = "{out}";
constexpr const char* kThen = " && ";
constexpr const char* kInput = " < ";
constexpr double kMostSeconds = 300.0;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The word with the folders in place of their names.
std::string located(std::string word, std::uint64_t seed, const WorkFolders& folders) {
  const std::pair<const char*, std::string> places[] = {
      {"{samples}", folders.samples},  {"{steps}", folders.steps},          {"{made}", folders.made},
      {"{public}", folders.open},      {kResult, folders.scratch + "/out"}, {"{scratch}", folders.scratch},
      {"{seed}", std::to_string(seed)}};
  for (const auto& [name, value] : places) {
    if (const auto at = word.find(name); at != std::string::npos) word.replace(at, std::string(name).size(), value);
  }
  return word;
}

/// The child of a case: words, and the file that is its standard input.
struct Child {
  ChildCommand command;
  std::string input;
};

Result<Child> childOf(const std::string& command, std::uint64_t seed, const WorkFolders& folders) {
  Child child;
  std::istringstream in(command);
  std::string word;
  in >> word;
  child.command.program = folders.programs + "/" + word;
  while (in >> word) {
    if (word == "<") {
      in >> word;
      auto content = readFile(located(word, seed, folders), 1U << 30U);
      if (!content) return content.error();
      child.input = std::move(*content);
    } else {
      child.command.arguments.push_back(located(word, seed, folders));
    }
  }
  return child;
}

/// Runs a command line to its end. `heap`: the file for counts of the heap; empty: nothing is counted.
Result<ChildEnd> carriedOut(const std::string& command, std::uint64_t seed, const WorkFolders& folders,
                            const std::string& heap) {
  auto child = childOf(command, seed, folders);
  if (!child) return child.error();
  child->command.input = child->input;
  child->command.environment = requiredEnvironment();
  if (!heap.empty()) {
    child->command.environment.push_back("LD_PRELOAD=" + folders.counter);
    child->command.environment.push_back("GLISSADE_HEAP_REPORT=" + heap);
  }
  child->command.limits.seconds = kMostSeconds;
  child->command.limits.outputBytes = 1U << 30U;
  auto end = runChild(child->command);
  if (end && (end->ending != ChildEnding::Exited || end->exitCode > 1)) {
    return Diagnostic{ErrorKind::Internal, command, "", "was not carried out: " + end->errors,
                      "Run the command line to see why."};
  }
  return end;
}

std::uint64_t numberAt(const Json& report, const char* name) {
  return report.contains(name) && report[name].is_number() ? report[name].get<std::uint64_t>() : 0;
}

/// Takes the counts of a planner's report.
void takeCounts(const std::string& output, Work& work) {
  const Json report = Json::parse(output, nullptr, false);
  if (!report.is_object() || !report.contains("collision_queries")) return;
  work[kPairs] = numberAt(report, "kernel_pairs");
  work[kQueries] = numberAt(report, "collision_queries") + numberAt(report, "distance_queries");
  work[kConfigurations] = numberAt(report, "random_configurations") + numberAt(report, "operator_configurations") +
                          numberAt(report, "contact_configurations");
  if (report["path"].is_object()) work[kSize] = numberAt(report["path"], "configurations");
}

Outcome takeHeap(const std::string& file, Work& work) {
  std::uint64_t counts[2] = {};
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(counts), sizeof(counts)) || counts[0] == 0) {
    return Diagnostic{ErrorKind::Internal, file, "", "holds no counts of the heap", "Build heap_count again."};
  }
  work[kAllocations] = counts[0];
  work[kPeakKb] = counts[1] / 1024;
  return Done{};
}

}  // namespace

Result<std::vector<WorkCase>> readCases(const std::string& file) {
  std::ifstream in(file);
  std::vector<WorkCase> cases;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const auto first = line.find('|');
    const auto second = first == std::string::npos ? first : line.find('|', first + 1);
    if (second == std::string::npos) {
      return Diagnostic{ErrorKind::MalformedInput, file, "line " + std::to_string(number), "is not a case",
                        "Write family | name | command."};
    }
    cases.push_back({trimmed(line.substr(0, first)), trimmed(line.substr(first + 1, second - first - 1)),
                     trimmed(line.substr(second + 1))});
  }
  return cases;
}

bool isThere(const WorkCase& each, const WorkFolders& folders) {
  return each.command.find("{public}") == std::string::npos || std::filesystem::is_directory(folders.open);
}

Result<WorkRow> measured(const WorkCase& each, std::uint64_t seed, const WorkFolders& folders) {
  const std::string heap = folders.scratch + "/heap";
  std::string command = each.command;
  if (const auto at = command.find(kThen); at != std::string::npos) {
    const auto prepared = carriedOut(command.substr(0, at), seed, folders, "");
    if (!prepared) return prepared.error();
    command = command.substr(at + std::string_view(kThen).size());
  }
  std::filesystem::remove(heap);
  const auto end = carriedOut(command, seed, folders, heap);
  if (!end) return end.error();
  const std::string out = located(kResult, seed, folders);
  WorkRow row{each.family, each.name, seed};
  takeCounts(end->output, row.work);
  if (const Outcome counted = takeHeap(heap, row.work); !counted) return counted.error();
  std::error_code absent;
  const auto written = std::filesystem::file_size(out, absent);
  if (!absent) {
    row.work[kSize] = written;
    std::filesystem::remove(out);
  } else if (command.find(kInput) != std::string::npos) {
    row.work[kSize] = end->output.size();
  }
  return row;
}

}  // namespace glissade::ratchet
