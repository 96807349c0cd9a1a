#include "tests/oracle/word_campaign.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <vector>

#include "tests/oracle/campaign_row.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/text_file.h"
#include "tests/oracle/word_mutation.h"

namespace glissade::oracle {
namespace {

namespace fs = std::filesystem;

constexpr int kInvalid = 1;
constexpr int kMalformed = 3;
constexpr int kUnderConditions = 7;

constexpr const char* kAcceptedClash = "3mm";

ChildEnd check(const WordOptions& options, const std::string& plan, bool clashesAreAccepted) {
  std::vector<std::string> command{options.cli, "check", options.product, plan};
  if (clashesAreAccepted) command.insert(command.end(), {"--accept-clashes", kAcceptedClash});
  return runChild(command, {120.0, 4096});
}

Json soundPlan(const WordOptions& options) {
  const std::string file = options.folder + "/plan.json";
  const ChildEnd planned = runChild(
      {options.cli, "sequence", options.product, "--out", file, "--seed", "1", "--accept-clashes", kAcceptedClash},
      {300.0, 4096});
  if (planned.exitCode != 0) throw std::runtime_error("sequence: " + planned.errors);
  std::ifstream stream(file);
  Json plan = Json::parse(stream);
  plan.erase("checksum");
  const std::string sound = options.folder + "/sound.json";
  writeText(sound, plan.dump(1));
  const ChildEnd checked = check(options, sound, true);
  if (checked.exitCode != 0) throw std::runtime_error("the sound plan is refused: " + checked.output + checked.errors);
  return plan;
}

/// The defect of the answer; empty: none.
std::string defectOf(const ChildEnd& end, MutantTruth truth) {
  if (end.hung) return "hangs";
  const int code = end.exitCode;
  const bool isRefused = code == kInvalid || code == kMalformed;
  const bool hasConditions =
      end.output.find("\ncondition: ") != std::string::npos || end.output.find("condition: ") == 0;
  if (code == kUnderConditions && !hasConditions) return "exit code 7 without a condition";
  if (truth == MutantTruth::False) return isRefused ? "" : "exit code " + std::to_string(code) + " of a false plan";
  if (isRefused || code == kUnderConditions) return "";
  if (truth == MutantTruth::Unknown && code == 0) return "";
  return "exit code " + std::to_string(code) + ", and no condition is named";
}

}  // namespace

int runWordMutations(const WordOptions& options) {
  fs::create_directories(options.folder);
  const Json sound = soundPlan(options);
  std::uint64_t defects = 0;
  std::map<std::string, std::map<int, std::uint64_t>> answers;
  for (std::uint64_t number = 0; number < options.mutants; ++number) {
    MutationDice dice(options.seed, number);
    Json plan = sound;
    const WordMutant mutant = mutateWords(plan, dice);
    const std::string file = options.folder + "/mutant-" + std::to_string(number) + ".json";
    writeText(file, plan.dump(1));
    const ChildEnd end = check(options, file, mutant.clashesAreAccepted);
    ++answers[mutant.what][end.exitCode];
    const std::string found = defectOf(end, mutant.truth);
    if (found.empty()) {
      fs::remove(file);
      continue;
    }
    ++defects;
    std::cerr << "DEFECT " << file << ": " << mutant.what << ": " << found << "\n";
  }
  for (const auto& [what, codes] : answers) {
    std::cerr << what << ":";
    for (const auto& [code, count] : codes) std::cerr << " " << count << " x " << code;
    std::cerr << "\n";
  }
  printRow("plans with words and numbers of their own", options.mutants, defects, options.seed);
  return defects == 0 ? 0 : 1;
}

}  // namespace glissade::oracle
