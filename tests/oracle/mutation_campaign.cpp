#include "tests/oracle/mutation_campaign.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "tests/oracle/campaign_row.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/exact_judge.h"
#include "tests/oracle/json_mutation.h"
#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/plan_oracle.h"
#include "tests/oracle/stated_file.h"
#include "tests/oracle/text_file.h"
#include "tests/oracle/trapped_pair.h"

namespace glissade::oracle {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMutantsOfAProduct = 50;
constexpr std::size_t kMostTriangles = 700;
constexpr int kSamplesOfAnEdge = 24;
constexpr double kMillimetre = 1e-3;

Json readJson(const std::string& file) {
  std::ifstream stream(file);
  return Json::parse(stream);
}

Triangles inMetres(Triangles triangles) {
  for (Triangle& triangle : triangles) {
    for (Point& p : triangle) p = kMillimetre * p;
  }
  return triangles;
}

/// A path or a plan that `check` calls valid.
struct Sound {
  std::string scenario;
  Json file;
  bool isPlan = false;
  std::vector<PlanBody> bodies;
  double fit = 0.0;      ///< overlap of the pair of a path, metres
  double radius = 0.0;   ///< radius of the object, metres
  double clearOf = 0.0;  ///< height of the block's top, metres
  double corner = 1.0;   ///< as TrappedPair::corner
};

class Mutations {
 public:
  explicit Mutations(const MutationOptions& options) : options_(options) {}

  int run() {
    for (std::uint64_t first = 0, product = 0; first < options_.mutants; ++product) {
      const Sound sound = product % 2 == 0 ? somePlan(product) : somePath(product);
      for (std::uint64_t i = 0; i < kMutantsOfAProduct && first < options_.mutants; ++i, ++first)
        tryMutant(sound, first);
    }
    if (2 * false_ < options_.mutants) {
      std::cerr << "DEFECT only " << false_ << " of " << options_.mutants << " mutants are false by the oracle\n";
      ++defects_;
    }
    std::cerr << false_ << " false by the oracle, " << valid_ << " others valid\n";
    printRow("mutated paths and plans", options_.mutants, defects_, options_.seed);
    printRow("mutated paths and plans, false by the oracle", false_, accepted_, options_.seed);
    return defects_ == 0 ? 0 : 1;
  }

 private:
  ChildEnd runCli(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), options_.cli);
    return runChild(arguments, {120.0, 4096});
  }

  void require(const ChildEnd& end, const std::string& what) {
    if (end.exitCode != 0) throw std::runtime_error(what + ": " + end.errors + end.output);
  }

  std::string newFolder(std::uint64_t product) {
    folder_ = options_.folder + "/" + std::to_string(product);
    fs::create_directories(folder_);
    return folder_;
  }

  /// A plan for two blocks with a pocket each and prisms in them, stacked with gaps.
  Sound somePlan(std::uint64_t product) {
    MutationDice dice(options_.seed, 1'000'000'007U + product);
    const std::string folder = newFolder(product);
    Sound sound{folder + "/scenario.json", {}, true, {}};
    std::vector<std::string> files;
    const auto add = [&](const std::string& id, const std::vector<Ring>& rings, double x) {
      const Triangles triangles = moved(trianglesOf(ringSolid(rings)), {x, 0.0, 0.0});
      writeText(folder + "/" + id + ".obj", meshFile(triangles, MeshFormat::Obj));
      files.push_back(folder + "/" + id + ".obj");
      sound.bodies.push_back({id, inMetres(triangles)});
    };
    for (int block = 0; block < 2; ++block) {
      const int corners = 3 + static_cast<int>(dice.below(10));
      const auto outline = [&](double radius) { return polarOutline(corners, {radius}); };
      const double radius = dice.uniform(8.0, 15.0);
      const int prisms = 2 + static_cast<int>(dice.below(2));
      const double height = dice.uniform(4.0, 8.0);
      const double gap = dice.uniform(0.1, 0.4);
      const double top = prisms * (height + gap) + 2.0;
      const double wide = block == 0 ? 3.0 : 2.5;
      const std::string name(1, block == 0 ? 'a' : 'b');
      add("block" + name,
          {{outline(wide * radius), -10.0},
           {outline(wide * radius), top},
           {outline(radius + 0.3), top},
           {outline(radius + 0.3), -gap}},
          100.0 * block);
      for (int i = 0; i < prisms; ++i) {
        const double z = i * (height + gap);
        add("prism" + name + std::to_string(i), {{outline(radius), z}, {outline(radius), z + height}}, 100.0 * block);
      }
    }
    std::vector<std::string> arguments{"new", sound.scenario, "--unit", "1mm", "--moves", files.back(), "--static"};
    arguments.insert(arguments.end(), files.begin(), files.end() - 1);
    require(runCli(arguments), "new");
    const std::string plan = folder + "/plan.json";
    require(runCli({"sequence", sound.scenario, "--out", plan, "--seed", "1"}), "sequence");
    sound.file = readJson(plan);
    sound.file.erase("checksum");
    checkSound(sound);
    return sound;
  }

  /// A path of a body that leaves its block upwards, with a fit.
  Sound somePath(std::uint64_t product) {
    for (std::uint64_t number = 1000 * product;; ++number) {
      TrappedPair pair = trappedPair(options_.seed, number, 3e-3);
      const Triangles object = inMetres(trianglesOf(ringSolid(pair.object)));
      if (pair.isTrapped() || object.size() > kMostTriangles) continue;
      const std::string folder = newFolder(product);
      Sound sound{folder + "/scenario.json", {}, false, {}};
      const Triangles block = inMetres(trianglesOf(ringSolid(pair.block)));
      writeText(folder + "/object.obj", meshFile(object, MeshFormat::Obj));
      writeText(folder + "/block.obj", meshFile(block, MeshFormat::Obj));
      require(runCli({"new", sound.scenario, "--unit", "1m", "--moves", folder + "/object.obj", "--static",
                      folder + "/block.obj"}),
              "new");
      const Json scenario = readJson(sound.scenario);
      const Point start = scenario.at("start").at("position").get<Point>();
      Point end = start;
      end[2] = scenario.at("workspace").at("max").at(2);
      sound.file = {{"format", "glissade-path"}, {"version", 1}, {"configurations", Json::array()}};
      for (int i = 0; i < 4; ++i) {
        const Point position = start + (i / 3.0) * (end - start);
        sound.file["configurations"].push_back(
            {{"position", position}, {"orientation", {0.0, 0.0, 0.0, 1.0}}, {"author", "computer"}});
      }
      std::ostringstream table;
      table.precision(17);
      for (const Json& pose : sound.file["configurations"]) {
        for (const double x : pose["position"]) table << x << " ";
        table << "0 0 0 1\n";
      }
      writeText(folder + "/straight.path", table.str());
      const ChildEnd checked = runCli({"check", sound.scenario, folder + "/straight.path", "--json"});
      if (checked.exitCode != 0) {
        std::cerr << "left out, see the campaign of trapped parts: " << folder << ": " << pair.name << "\n";
        continue;
      }
      sound.file["allowances"] = Json::array();
      const Json certificate = Json::parse(checked.output).at("certificate");
      for (const Json& each : certificate.value("allowances", Json::array())) {
        sound.file["allowances"].push_back(
            {{"body", each.at("body")}, {"allowance_m", each.at("allowance_m")}, {"yields", each.at("yields")}});
      }
      sound.bodies = {{"block", block}, {"object", moved(object, -1.0 * start)}};
      for (const Triangle& triangle : sound.bodies[1].triangles) {
        for (const Point& p : triangle) sound.radius = std::max(sound.radius, length(p));
      }
      sound.fit = kMillimetre * pair.fit;
      sound.corner = pair.corner;
      sound.clearOf = kMillimetre * pair.top;
      checkSound(sound);
      return sound;
    }
  }

  void checkSound(const Sound& sound) {
    writeText(folder_ + "/sound.json", sound.file.dump(1));
    require(runCli({"check", sound.scenario, folder_ + "/sound.json"}), folder_ + "/sound.json");
  }

  /// An upper bound of the allowances, metres, that the evidence for the pair supports.
  static double mostOf(const Sound& sound) { return 1.5 * sound.fit + 5e-4 * sound.radius + 5e-6; }

  std::string whyFalsePath(const Sound& sound, const Json& path) const {
    const auto poses = statedPoses(path.at("configurations"));
    if (!poses) return "a pose is not one";
    for (const Json& each : path.at("allowances")) {
      const auto metres = statedAllowance(each);
      if (!metres) return "an allowance is no length";
      if (*metres > mostOf(sound)) return "an allowance is larger than all evidence";
      if (each.at("body") != "block" || each.value("moving", "object") != "object") return "another body";
      if (each.contains("pitch_m") && !(each["pitch_m"].is_number() && std::abs(each["pitch_m"].get<double>()) < 1e9))
        return "a pitch is no length";
    }
    const Point start = sound.file["configurations"][0]["position"].get<Point>();
    if (length(poses->front().position - start) > 1e-5 * sound.radius) return "it does not begin at the start";
    if (poses->back().position[2] < sound.clearOf && length(poses->back().position - start) < sound.radius)
      return "it ends inside";
    const StatedSum stated = statedAgainst(path.at("allowances"), "block");
    const double deep = sound.corner * (stated.moving + stated.yielding) + 1e-4 * sound.fit + 1e-6;
    const ExactJudge judge({{sound.bodies[0].triangles}, sound.bodies[1].triangles});
    for (std::size_t edge = 0; edge + 1 < poses->size(); ++edge) {
      for (int i = 0; i <= kSamplesOfAnEdge; ++i) {
        const Placement pose = between((*poses)[edge], (*poses)[edge + 1], static_cast<double>(i) / kSamplesOfAnEdge);
        if (judge.depthAt(pose) > deep) return "it penetrates deeper than stated";
      }
    }
    return {};
  }

  void tryMutant(const Sound& sound, std::uint64_t number) {
    MutationDice dice(options_.seed, number);
    Json mutant = sound.file;
    std::string what;
    std::vector<std::string> ids;
    for (const PlanBody& body : sound.bodies) ids.push_back(body.id);
    const std::size_t changes = 1 + dice.below(4) / 3;
    std::string why;
    for (std::size_t i = 0; i < changes; ++i) {
      if (i > 0 && !why.empty()) break;
      what += (i > 0 ? ", " : "") + (sound.isPlan ? mutatePlan(mutant, ids, dice) : mutatePath(mutant, "block", dice));
      why = sound.isPlan ? whyFalse(mutant, sound.bodies) : whyFalsePath(sound, mutant);
    }
    const std::string file = folder_ + "/mutant-" + std::to_string(number) + ".json";
    writeText(file, mutant.dump(1));
    const ChildEnd end = runCli({"check", sound.scenario, file});
    const std::string found = defectOf(end, why, ids);
    false_ += why.empty() ? 0 : 1;
    valid_ += why.empty() && end.exitCode == 0 ? 1 : 0;
    accepted_ += !why.empty() && end.exitCode == 0 ? 1 : 0;
    if (found.empty()) {
      fs::remove(file);
      return;
    }
    ++defects_;
    std::cerr << "DEFECT " << file << ": " << what << " (" << why << "): " << found << "\n";
  }

  static std::string defectOf(const ChildEnd& end, const std::string& why, const std::vector<std::string>& ids) {
    if (end.hung) return "hangs";
    constexpr int kUnderConditions = 7;
    const bool isAnswered = end.exitCode == 0 || end.exitCode == 1 || end.exitCode == 3;
    if (!isAnswered && end.exitCode != kUnderConditions) return "exit code " + std::to_string(end.exitCode);
    if (end.exitCode == 0 || end.exitCode == kUnderConditions) return why.empty() ? "" : "is called valid";
    const std::string text = end.output + end.errors;
    const auto names = [&](const std::string& word) { return text.find(word) != std::string::npos; };
    bool named = names("step ") || names("/steps/") || names("the plan ") || names("the path does not") ||
                 names("parts have no step") || names("/configurations") || names("/allowances") ||
                 names("configuration ") || names("edge ");
    for (const std::string& id : ids) named = named || names("'" + id + "'");
    for (const char* key : {"/parts", "/removed", "/end", "/deflection_m", "/staying", "/bodies"})
      named = named || names(key);
    return named ? "" : "the refusal names nothing: " + text.substr(0, 300);
  }

  const MutationOptions& options_;
  std::string folder_;
  std::uint64_t false_ = 0;
  std::uint64_t valid_ = 0;
  std::uint64_t accepted_ = 0;
  std::uint64_t defects_ = 0;
};

}  // namespace

int runMutations(const MutationOptions& options) { return Mutations(options).run(); }

}  // namespace glissade::oracle
