// Counts the work of problems, products and files, and compares it with the table that the project keeps.
//
// usage: work_ratchet CASES TABLE FOLDERS... [--more CASES] [--seeds N] [--family NAME] [--record REASON]
// FOLDERS: programs, samples, STEP files, made problems, public problems, library heap_count.
// Without --record, it prints the values that have risen by more than their limits; the exit code is 1 if there are
// any. With --record, it writes changed rows with the reason.
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/child_process.h"
#include "engine/base/file.h"
#include "engine/base/result.h"
#include "tests/ratchet/work.h"
#include "tests/ratchet/work_table.h"

namespace glissade::ratchet {
namespace {

/// A command line whose work is counted.
struct WorkCase {
  std::string family;
  std::string name;
  std::string command;  ///< as in a line of cases.txt
};

/// Folders that the command lines use.
struct WorkFolders {
  std::string programs;  ///< folder of glissade-cli and the importers
  std::string samples;
  std::string steps;    ///< files of tests/step_files
  std::string made;     ///< problems of generate-made-problems
  std::string open;     ///< public problems; their cases are skipped if the folder is absent
  std::string scratch;  ///< for files that cases write
  std::string counter;  ///< the library heap_count
};

using Json = nlohmann::json;

constexpr const char* kResult = "{out}";

constexpr const char* kThen = " && ";

constexpr const char* kInput = " < ";

constexpr double kMostSeconds = 300.0;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The word with the paths of folders in place of their names.
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

/// The child of a case: its words, and the file for its standard input.
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
    return Diagnostic{ErrorKind::Internal, command, "", Message("was not carried out: " + end->errors),
                      Message("Run the command line to see why.")};
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
    return Diagnostic{ErrorKind::Internal, file, "", Message("holds no counts of the heap"),
                      Message("Build heap_count again.")};
  }
  work[kAllocations] = counts[0];
  work[kPeakKb] = counts[1] / 1024;
  return Done{};
}

/// The cases of a file. Errors: MalformedInput with the line.
Result<std::vector<WorkCase>> readCases(const std::string& file) {
  std::ifstream in(file);
  std::vector<WorkCase> cases;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const auto first = line.find('|');
    const auto second = first == std::string::npos ? first : line.find('|', first + 1);
    if (second == std::string::npos) {
      return Diagnostic{ErrorKind::MalformedInput, file, "line " + std::to_string(number), Message("is not a case"),
                        Message("Write family | name | command.")};
    }
    cases.push_back({trimmed(line.substr(0, first)), trimmed(line.substr(first + 1, second - first - 1)),
                     trimmed(line.substr(second + 1))});
  }
  return cases;
}

/// Whether the case's files exist; public problems may be absent.
bool isThere(const WorkCase& each, const WorkFolders& folders) {
  return each.command.find("{public}") == std::string::npos || std::filesystem::is_directory(folders.open);
}

/// Carries the case out. Errors: Internal with the program's message if the program fails.
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

struct Options {
  std::vector<std::string> cases;  ///< files
  std::string table;
  WorkFolders folders;
  std::uint64_t seeds = 1;
  std::string family;
  std::string reason;
};

std::optional<Options> optionsOf(const std::vector<std::string>& words) {
  Options options;
  std::vector<std::string> places;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool named = words[i].rfind("--", 0) == 0;
    if (!named) {
      places.push_back(words[i]);
      continue;
    }
    if (i + 1 == words.size()) return std::nullopt;
    const std::string& value = words[++i];
    if (words[i - 1] == "--more") {
      options.cases.push_back(value);
    } else if (words[i - 1] == "--seeds") {
      std::from_chars(value.data(), value.data() + value.size(), options.seeds);
    } else if (words[i - 1] == "--family") {
      options.family = value;
    } else if (words[i - 1] == "--record") {
      options.reason = value;
    } else {
      return std::nullopt;
    }
  }
  if (places.size() != 8) return std::nullopt;
  options.cases.push_back(places[0]);
  options.table = places[1];
  options.folders = {places[2], places[3], places[4], places[5], places[6], "", places[7]};
  return options;
}

int fail(const Diagnostic& why) {
  std::cerr << "work_ratchet: " << toString(why) << "\n";
  return 2;
}

Result<std::vector<WorkRow>> measureAll(const std::vector<WorkCase>& cases, const Options& options) {
  std::vector<WorkRow> rows;
  std::size_t absent = 0;
  for (const WorkCase& each : cases) {
    if (!options.family.empty() && each.family != options.family) continue;
    if (!isThere(each, options.folders)) {
      ++absent;
      continue;
    }
    const bool seeded = each.command.find("{seed}") != std::string::npos;
    for (std::uint64_t seed = 1; seed <= (seeded ? options.seeds : 1); ++seed) {
      auto row = measured(each, seed, options.folders);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  }
  if (absent > 0) std::cout << "skipped: " << absent << " cases of public problems, which are absent\n";
  return rows;
}

int run(Options options) {
  std::vector<WorkCase> cases;
  for (const std::string& file : options.cases) {
    const auto read = readCases(file);
    if (!read) return fail(read.error());
    cases.insert(cases.end(), read->begin(), read->end());
  }
  options.folders.scratch = std::filesystem::temp_directory_path() / ("work-ratchet-" + std::to_string(::getpid()));
  std::filesystem::create_directories(options.folders.scratch);
  const auto rows = measureAll(cases, options);
  std::filesystem::remove_all(options.folders.scratch);
  if (!rows) return fail(rows.error());

  std::vector<WorkRow> before;
  if (std::filesystem::exists(options.table)) {
    const auto text = readFile(options.table, 1U << 24U);
    if (!text) return fail(text.error());
    const auto read = readTable(*text, options.table);
    if (!read) return fail(read.error());
    before = *read;
  }
  if (!options.reason.empty()) {
    const Outcome saved = writeFileAtomically(options.table, writeTable(recorded(before, *rows, options.reason)));
    return saved ? 0 : fail(saved.error());
  }
  const auto faults = risen(before, *rows);
  for (const std::string& fault : faults) std::cout << fault << "\n";
  std::cout << rows->size() << " cases were carried out, " << faults.size() << " faults\n";
  return faults.empty() ? 0 : 1;
}

}  // namespace
}  // namespace glissade::ratchet

int main(int argc, char** argv) {
  const auto options = glissade::ratchet::optionsOf({argv + 1, argv + argc});
  if (options) return glissade::ratchet::run(*options);
  std::cerr << "usage: work_ratchet CASES TABLE PROGRAMS SAMPLES STEPS MADE PUBLIC COUNTER"
               " [--more CASES] [--seeds N] [--family NAME] [--record REASON]\n";
  return 2;
}
