// Counts the work of problems, products and files, and compares it with the table that the project keeps.
//
// usage: work_ratchet CASES TABLE FOLDERS... [--more CASES] [--seeds N] [--family NAME] [--record REASON]
// FOLDERS: programs, samples, STEP files, made problems, public problems, library heap_count.
// Without --record, prints what has risen by more than it may; the exit code is 1 where something has. With --record,
// rows that have changed are written with the reason.
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "engine/base/file.h"
#include "tests/ratchet/work_cases.h"
#include "tests/ratchet/work_table.h"

namespace glissade::ratchet {
namespace {

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
