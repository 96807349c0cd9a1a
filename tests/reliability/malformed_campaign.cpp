// Gives glissade-cli malformed files of every format, and prints one row of the table of packaging/reliability.sh for
// each: name | tried | clean | defects | seconds | peak MB | seed. FORMAT: only this one. Uses nothing of the engine.
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/oracle/child_run.h"
#include "tests/reliability/good_files.h"
#include "tests/reliability/mutations.h"

namespace glissade::reliability {
namespace {

namespace fs = std::filesystem;
using oracle::ChildEnd;
using oracle::ChildLimits;
using oracle::runChild;

struct Options {
  std::string cli;
  std::string folder;     ///< folder of the campaign; variants with a defect stay in it
  std::string stepFiles;  ///< path of a folder, or empty
  std::uint64_t seed = 1;
  std::size_t variants = 200;           ///< number of variants of each format
  std::size_t truncations = 1'000'000;  ///< most truncations of each good file
  std::string format;                   ///< empty: all
};

struct Row {
  std::string name;
  std::size_t tried = 0;
  std::size_t defects = 0;
  double seconds = 0.0;
  long megabytes = 0;
};

class Campaign {
 public:
  explicit Campaign(Options options) : options_(std::move(options)) {}

  int run() {
    const std::vector<GoodFile> files = makeGoodFiles(options_.folder, options_.cli, options_.stepFiles);
    std::size_t defects = 0;
    for (const GoodFile& file : files) {
      if (!options_.format.empty() && options_.format != file.format) continue;
      checkTheGoodOne(file);
      defects += print(mutations(file));
      defects += print(truncations(file));
      put(file, file.content);
    }
    return defects == 0 ? 0 : 1;
  }

 private:
  void put(const GoodFile& file, const std::string& content) const {
    std::ofstream(options_.folder + "/" + file.name, std::ios::binary) << content;
  }

  ChildEnd ask(const GoodFile& file) const {
    std::vector<std::string> command{options_.cli};
    command.insert(command.end(), file.command.begin(), file.command.end());
    return runChild(command, limits_);
  }

  void checkTheGoodOne(const GoodFile& file) const {
    const ChildEnd end = ask(file);
    if (end.exitCode != 0) std::cerr << file.format << ": the good file is refused: " << end.errors << end.output;
  }

  Row mutations(const GoodFile& file) {
    Row row{"malformed " + file.format};
    std::mt19937_64 engine(options_.seed);
    for (std::size_t i = 0; i < options_.variants; ++i) tryOne(file, mutated(file.content, engine), false, row);
    return row;
  }

  Row truncations(const GoodFile& file) {
    Row row{"truncated " + file.format};
    const std::size_t stride =
        std::max<std::size_t>(1, (file.content.size() + options_.truncations - 1) / options_.truncations);
    for (std::size_t length = 0; length < file.content.size(); length += stride) {
      tryOne(file, file.content.substr(0, length), true, row);
    }
    return row;
  }

  void tryOne(const GoodFile& file, const std::string& content, bool cut, Row& row) {
    put(file, content);
    const ChildEnd end = ask(file);
    ++row.tried;
    row.seconds += end.seconds;
    row.megabytes = std::max(row.megabytes, end.megabytes);
    std::string defect = defectOf(end);
    if (defect.empty() && cut && file.mesh) defect = silentLoss(file, content, end);
    if (defect.empty()) return;
    const std::string kept = options_.folder + "/defect" + std::to_string(kept_++) + "-" + file.name;
    std::ofstream(kept, std::ios::binary) << content;
    std::cerr << "DEFECT " << row.name << ": " << defect << " (" << kept << ")\n";
    ++row.defects;
  }

  std::string defectOf(const ChildEnd& end) const {
    if (end.hung) return "no end within " + std::to_string(limits_.seconds) + " s";
    if (end.signal != 0) return "signal " + std::to_string(end.signal);
    if (end.megabytes > limits_.megabytes) return std::to_string(end.megabytes) + " MB";
    if (end.exitCode < 0 || end.exitCode > 5) return "exit code " + std::to_string(end.exitCode) + ": " + end.errors;
    if (end.exitCode != 0 && end.errors.empty() && end.output.empty()) return "refused without a message";
    return "";
  }

  /// The loss in a truncated mesh that is accepted without a warning although triangles are missing.
  static std::string silentLoss(const GoodFile& file, const std::string& content, const ChildEnd& end) {
    if (end.exitCode != 0 || !end.errors.empty()) return "";
    const auto report = nlohmann::json::parse(end.output, nullptr, false);
    if (report.is_discarded() || !report.contains("object")) return "no report";
    const auto found = report["object"].value("triangles", std::size_t{0});
    const std::size_t begun = trianglesBegun(file, content);
    if (found == begun) return "";
    return "silently " + std::to_string(found) + " triangles, " + std::to_string(begun) + " were begun";
  }

  std::size_t print(const Row& row) const {
    std::cout << row.name << " | " << row.tried << " | " << row.tried - row.defects << " | " << row.defects << " | "
              << std::lround(row.seconds) << " | " << row.megabytes << " | " << options_.seed << std::endl;
    return row.defects;
  }

  Options options_;
  ChildLimits limits_;
  std::size_t kept_ = 0;
};

}  // namespace
}  // namespace glissade::reliability

int main(int argc, char** argv) {
  using namespace glissade::reliability;
  if (argc != 7 && argc != 8) {
    std::cerr << "usage: malformed_campaign GLISSADE_CLI FOLDER STEP_FILES SEED VARIANTS TRUNCATIONS [FORMAT]\n";
    return 2;
  }
  fs::create_directories(argv[2]);
  return Campaign({argv[1], argv[2], argv[3], std::stoull(argv[4]), std::stoull(argv[5]), std::stoull(argv[6]),
                   argc == 8 ? argv[7] : ""})
      .run();
}
