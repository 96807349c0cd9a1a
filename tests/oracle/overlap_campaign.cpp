#include "tests/oracle/overlap_campaign.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/oracle/campaign_row.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/overlap_case.h"
#include "tests/oracle/text_file.h"

namespace glissade::oracle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double kSeconds = 300.0;  // a machine may be busy
/// Millimetres; after a motion of this length the boxes of the solids are apart.
constexpr double kFar = 500.0;
/// Exact volumes take a second each.
constexpr std::uint64_t kExactEvery = 4;

class Overlaps {
 public:
  explicit Overlaps(const OverlapOptions& options) : options_(options) {}

  int run() {
    for (std::uint64_t i = 0; i < options_.cases; ++i) tryCase(i);
    const auto print = [&](const char* name, const char* key) {
      printRow(name, tried_[key], defects_[key], options_.seed);
    };
    print("overlaps, sequences", "sequence");
    print("overlaps, paths on blocked ways", "blocked");
    print("overlaps, free ways", "free");
    print("overlaps, exact common volumes", "volumes");
    std::uint64_t defects = 0;
    for (const auto& [name, count] : defects_) defects += count;
    return defects == 0 ? 0 : 1;
  }

 private:
  void tryCase(std::uint64_t number) {
    const OverlapCase pair = overlapCase(options_.seed, number);
    folder_ = options_.folder + "/" + std::to_string(number);
    name_ = folder_ + ": " + pair.name;
    const std::uint64_t before = found_;
    fs::create_directories(folder_);
    writeCase(pair, folder_ + "/object.step", folder_ + "/block.step");
    accept_.clear();
    if (pair.accepted > 0.0) accept_ = {"--accept-clashes", std::to_string(pair.accepted) + "mm"};
    if (pair.accepted > 0.0 && pair.cutsBlock) accept_.insert(accept_.end(), {"--cut", "block"});
    const ChildEnd made = runCli({"new", scenario(), "--moves", folder_ + "/object.step", "--static",
                                  folder_ + "/block.step", "--deflection", "0.02mm"});
    if (made.exitCode != 0) {
      find("sequence", "no scenario: " + made.errors);
      return;
    }
    trySequence(pair);
    for (const Direction& way : pair.blocked) tryBlocked(pair, way);
    if (number % kExactEvery == 0) checkVolumes(pair);
    if (found_ == before) fs::remove_all(folder_);
  }

  void find(const std::string& kind, const std::string& what) {
    std::cerr << "DEFECT " << name_ << ": " << what << "\n";
    ++defects_[kind];
    ++found_;
  }

  std::string scenario() const { return folder_ + "/scenario.json"; }

  ChildEnd runCli(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), options_.cli);
    return runChild(arguments, {kSeconds, 4096});
  }

  ChildEnd runAccepting(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), accept_.begin(), accept_.end());
    return runCli(std::move(arguments));
  }

  /// The direction of the plan's only motion, of the object relative to the block.
  Direction wayOf(const std::string& plan) const {
    std::ifstream stream(plan);
    const Json json = Json::parse(stream);
    const Json& motion = json.at("steps").at(0).at("motions").at(0);
    const Json& points = motion.at("path");
    Direction way{};
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      way[i] = points.back().at("position").at(i).get<double>() - points.front().at("position").at(i).get<double>();
      length = std::hypot(length, way[i]);
    }
    std::ifstream file(scenario());
    const bool isObject = Json::parse(file).at("object").at("id") == motion.at("bodies").at(0);
    for (double& each : way) each *= (isObject ? 1.0 : -1.0) / length;
    return way;
  }

  void trySequence(const OverlapCase& pair) {
    ++tried_["sequence"];
    const std::string plan = folder_ + "/plan.json";
    const ChildEnd end = runAccepting({"sequence", scenario(), "--time-limit", "100", "--out", plan});
    const bool leaves = end.exitCode == 0;
    if (!pair.leaves()) {
      if (leaves) find("sequence", "leaves, although every way is blocked");
      return;
    }
    ++tried_["free"];
    if (!leaves) return find("free", "does not leave: " + end.output.substr(0, 800) + end.errors.substr(0, 800));
    const ChildEnd judged = runAccepting({"check", scenario(), plan});
    if (judged.exitCode != 0) find("free", "leaves, and check says: " + judged.output.substr(0, 800) + judged.errors);
    const Direction way = wayOf(plan);
    for (const Direction& blocked : pair.blocked) {
      const double cosine = way[0] * blocked[0] + way[1] * blocked[1] + way[2] * blocked[2];
      if (cosine > 0.99) find("sequence", "leaves on a way that is blocked");
    }
  }

  Json claim(const std::string& body, double allowance, bool yields, bool isCut) const {
    Json entry{{"body", body}, {"allowance_m", allowance}};
    if (yields) entry["yields"] = true;
    if (isCut) entry["hollow"] = true;
    return entry;
  }

  /// Metres from the start to the wall of the scenario's workspace in the direction. The workspace is larger than the
  /// motion that takes the object out of the block.
  static double roomIn(const Json& scenario, const Direction& way) {
    double room = 1e-3 * kFar;
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::abs(way[i]) < 1e-9) continue;
      const double wall = scenario.at("workspace").at(way[i] > 0.0 ? "max" : "min").at(i).get<double>();
      room = std::min(room, (wall - scenario.at("start").at("position").at(i).get<double>()) / way[i]);
    }
    return room;
  }

  void tryBlocked(const OverlapCase& pair, const Direction& way) {
    std::ifstream stream(scenario());
    const Json json = Json::parse(stream);
    const std::string block = json.at("bodies").at(0).at("id");
    const double depth = 1e-3 * std::max(pair.accepted, 1.0);
    const double margin = 1e-6;
    const std::vector<Json> claims{
        Json::array(),
        {claim(block, depth, false, false)},
        {claim(block, depth, true, false)},
        {claim(block, depth, false, false), claim(block, depth, true, false)},
        {claim(block, depth, false, true), claim(block, margin, true, false)},
        {claim(block, depth, true, true), claim(block, margin, false, false)},
    };
    const Json& start = json.at("start").at("position");
    for (const Json& allowances : claims) {
      ++tried_["blocked"];
      Json path{{"format", "glissade-path"}, {"version", 1}, {"allowances", allowances}};
      for (const double length : {0.0, 0.999 * roomIn(json, way)}) {
        Json position = Json::array();
        for (std::size_t i = 0; i < 3; ++i) position.push_back(start.at(i).get<double>() + length * way[i]);
        path["configurations"].push_back(
            {{"position", position}, {"orientation", json.at("start").at("orientation")}, {"author", "computer"}});
      }
      writeText(folder_ + "/path.json", path.dump(2));
      const ChildEnd end = runAccepting({"check", scenario(), folder_ + "/path.json"});
      const bool isJudged = end.output.find("workspace") == std::string::npos;
      if (end.exitCode != 1 || !isJudged) {
        std::ostringstream what;
        what << "exit code " << end.exitCode << " on the way " << way[0] << " " << way[1] << " " << way[2] << " with "
             << allowances.dump() << ": " << end.output.substr(0, 500) << end.errors.substr(0, 500);
        find("blocked", what.str());
      }
    }
  }

  /// Checks that the object shares a volume with the block on blocked ways, away from its assembled pose.
  void checkVolumes(const OverlapCase& pair) {
    for (const Direction& way : pair.blocked) {
      ++tried_["volumes"];
      bool shares = false;
      for (double length = 1.0; length < kFar && !shares; length *= 1.4) {
        shares = sharedVolume(pair, way, length) > 0.0;
      }
      if (!shares) find("volumes", "the exact solids share nothing on a blocked way");
    }
    for (const Direction& way : pair.free) {
      ++tried_["volumes"];
      const double first = sharedVolume(pair, way, 0.0);
      for (double length = 1.0; length < kFar; length *= 1.6) {
        if (sharedVolume(pair, way, length) <= first * (1.0 + 1e-6)) continue;
        find("volumes", "the exact solids share more on a free way than where they are assembled");
        break;
      }
      if (sharedVolume(pair, way, kFar) > 0.0) find("volumes", "the exact solids share a volume at the end");
    }
  }

  const OverlapOptions& options_;
  std::string folder_;
  std::string name_;
  std::vector<std::string> accept_;
  std::map<std::string, std::uint64_t> tried_;
  std::map<std::string, std::uint64_t> defects_;
  std::uint64_t found_ = 0;
};

}  // namespace

int runOverlaps(const OverlapOptions& options) { return Overlaps(options).run(); }

}  // namespace glissade::oracle
