#include "tests/oracle/trapped_campaign.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "tests/oracle/campaign_row.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/ring_solid.h"
#include "tests/oracle/text_file.h"
#include "tests/oracle/trapped_pair.h"

namespace glissade::oracle {
namespace {

TopoDS_Face planeFace(const std::vector<Point>& corners) {
  BRepBuilderAPI_MakePolygon border;
  for (const Point& p : corners) border.Add(gp_Pnt(p[0], p[1], p[2]));
  border.Close();
  return BRepBuilderAPI_MakeFace(border.Wire(), true);
}

TopoDS_Shape faceted(const std::vector<Ring>& rings) {
  BRepBuilderAPI_Sewing sewing(1e-7);
  for (const Polygon& polygon : ringSolid(rings)) sewing.Add(planeFace(polygon.corners));
  sewing.Perform();
  TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
  if (!shells.More()) throw std::runtime_error("the faces make no shell");
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current()));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape revolved(const std::vector<Ring>& rings) {
  std::vector<Point> profile{{0.0, 0.0, rings.front().z}};
  for (const Ring& ring : rings) profile.push_back({std::hypot(ring.outline[0][0], ring.outline[0][1]), 0.0, ring.z});
  profile.push_back({0.0, 0.0, rings.back().z});
  TopoDS_Shape solid = BRepPrimAPI_MakeRevol(planeFace(profile), gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1))).Shape();
  TopExp_Explorer solids(solid, TopAbs_SOLID);
  if (!solids.More()) throw std::runtime_error("the profile makes no solid");
  TopoDS_Solid one = TopoDS::Solid(solids.Current());
  BRepLib::OrientClosedSolid(one);
  return one;
}

TopoDS_Shape solidOf(const std::vector<Ring>& rings, bool round) { return round ? revolved(rings) : faceted(rings); }

/// Writes a solid of rings (millimetres) as a STEP file by OpenCASCADE: plane faces, or surfaces of revolution through
/// the rings' radii. Throws std::runtime_error.
void writeStep(const std::string& file, const std::vector<Ring>& rings, bool round) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // prevents statistics on the standard output
  STEPControl_Writer writer;
  const bool written = writer.Transfer(solidOf(rings, round), STEPControl_AsIs) == IFSelect_RetDone &&
                       writer.Write(file.c_str()) == IFSelect_RetDone;
  if (!written) throw std::runtime_error(file + ": cannot be written");
}

/// The volume that the exact solids share when the object is lifted, cubic millimetres.
double commonVolume(const TrappedPair& pair, double lifted) {
  gp_Trsf up;
  up.SetTranslation(gp_Vec(0.0, 0.0, lifted));
  const TopoDS_Shape object = solidOf(pair.object, pair.round).Moved(TopLoc_Location(up));
  BRepAlgoAPI_Common common(object, solidOf(pair.block, pair.round));
  if (!common.IsDone()) throw std::runtime_error("the common volume was not found");
  GProp_GProps properties;
  BRepGProp::VolumeProperties(common.Shape(), properties);
  return properties.Mass();
}

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Millimetres above the judge's allowance for bodies that touch: a micrometre for the attack, and two for rounding and
/// fitting.
constexpr double kLeastLip = 3e-3;
/// Deflection of curved surfaces, millimetres: triangles of both bodies deviate by up to this.
constexpr double kDeflection = 0.01;
constexpr const char* kPlanSeconds = "2";
/// Exact volumes take a second each.
constexpr std::uint64_t kVolumeEvery = 4;

Json poseAt(double z) {
  return {{"position", {0.0, 0.0, z}}, {"orientation", {0.0, 0.0, 0.0, 1.0}}, {"author", "computer"}};
}

class Trapped {
 public:
  explicit Trapped(const TrappedOptions& options) : options_(options) {}

  int run() {
    for (std::uint64_t i = 0; i < options_.pairs; ++i) tryPair(i);
    const auto print = [&](const char* name, const char* key) {
      printRow(name, tried_[key], defects_[key], options_.seed);
    };
    print("trapped parts, paths through the lip", "trapped");
    print("trapped parts, planned", "planned");
    print("trapped parts, exact common volumes", "volumes");
    print("free parts beside them", "free");
    if (options_.open) std::cout << "free open parts that leave: " << left_ << " of " << tried_["free"] << "\n";
    std::uint64_t defects = 0;
    for (const auto& [name, count] : defects_) defects += count;
    return defects == 0 ? 0 : 1;
  }

 private:
  void tryPair(std::uint64_t number) {
    const bool step = isStep(number);
    TrappedPair pair = trappedPair(options_.seed, number, kLeastLip);
    if (step && pair.round) pair = trappedPair(options_.seed, number, kLeastLip + 2.0 * kDeflection);
    if (!step) pair.round = false;
    folder_ = options_.folder + "/" + std::to_string(number);
    name_ = folder_ + ": " + pair.name;
    const std::uint64_t before = found_;
    fs::create_directories(folder_);
    if (!writeScenario(pair, number)) return;
    tryPaths(pair);
    if (pair.isTrapped() && number % options_.planEvery == 0) plan();
    if (number % kVolumeEvery == 0 && !options_.open) checkVolume(pair);
    if (found_ == before) fs::remove_all(folder_);
  }

  void find(const std::string& kind, const std::string& what) {
    std::cerr << "DEFECT " << name_ << ": " << what << "\n";
    ++defects_[kind];
    ++found_;
  }

  ChildEnd runCli(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), options_.cli);
    return runChild(arguments, {120.0, 4096});
  }

  bool writeScenario(const TrappedPair& pair, std::uint64_t number) {
    constexpr MeshFormat kFormats[] = {MeshFormat::TextStl, MeshFormat::BinaryStl, MeshFormat::Obj, MeshFormat::Glb};
    const MeshFormat format = kFormats[number / 2 % 4];
    const bool step = isStep(number);
    const std::string ending = step ? ".step" : endingOf(format);
    const std::string object = folder_ + "/object" + ending;
    const std::string block = folder_ + "/block" + ending;
    if (step) {
      writeStep(object, pair.object, pair.round);
      writeStep(block, pair.block, pair.round);
    } else {
      std::seed_seq words{options_.seed, number, std::uint64_t{0x09e7}};
      std::mt19937_64 random(words);
      writeText(object, meshFile(trianglesOf(facesOf(pair.object, random)), format));
      writeText(block, meshFile(trianglesOf(facesOf(pair.block, random)), format));
    }
    std::vector<std::string> arguments{"new",      scenario(), "--moves",      object,
                                       "--static", block,      "--deflection", "0.01mm"};
    if (!step) arguments.insert(arguments.end(), {"--unit", "1mm", "--up", "z"});
    const ChildEnd made = runCli(arguments);
    if (made.exitCode != 0) find("free", "no scenario: " + made.errors);
    return made.exitCode == 0;
  }

  bool isStep(std::uint64_t number) const { return number % 2 == 0 && !options_.open; }

  /// All faces, or all except up to three. At least one body of a pair is open.
  std::vector<Polygon> facesOf(const std::vector<Ring>& rings, std::mt19937_64& random) {
    std::vector<Polygon> faces = ringSolid(rings);
    if (!options_.open) return faces;
    const std::uint64_t lost = isSecond_ ? random() % 4 : 1 + random() % 3;
    for (std::uint64_t i = 0; i < lost; ++i) {
      faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(random() % faces.size()));
    }
    isSecond_ = !isSecond_;
    return faces;
  }

  std::string scenario() const { return folder_ + "/scenario.json"; }

  /// Writes a path straight up and out.
  std::string writePath(const std::string& name, double allowance, bool yields) {
    std::ifstream stream(scenario());
    const Json json = Json::parse(stream);
    const Json& start = json.at("start").at("position");
    const double z = start.at(2);
    const double top = json.at("workspace").at("max").at(2);
    Json path{{"format", "glissade-path"}, {"version", 1}};
    for (const double height : {z, top}) {
      Json point = poseAt(height);
      point["position"] = {start.at(0), start.at(1), height};
      path["configurations"].push_back(point);
    }
    path["allowances"] = Json::array();
    if (allowance > 0.0) {
      Json entry{{"body", json.at("bodies").at(0).at("id")}, {"allowance_m", allowance}};
      if (yields) entry["yields"] = true;
      path["allowances"].push_back(entry);
    }
    writeText(folder_ + "/" + name, path.dump(2));
    return folder_ + "/" + name;
  }

  /// Writes the path in a format that states no allowances, so that the judge applies its own.
  std::string writeTable() {
    const std::string json = writePath("straight.json", 0.0, false);
    std::ifstream stream(json);
    const Json path = Json::parse(stream);
    std::ostringstream text;
    text.precision(17);
    for (const Json& point : path.at("configurations")) {
      for (const double x : point.at("position")) text << x << " ";
      text << "0 0 0 1\n";
    }
    writeText(folder_ + "/straight.path", text.str());
    return folder_ + "/straight.path";
  }

  ChildEnd check(const std::string& path) { return runCli({"check", scenario(), path, "--json"}); }

  void tryPaths(const TrappedPair& pair) {
    const std::string kind = pair.isTrapped() ? "trapped" : "free";
    const ChildEnd own = check(writeTable());
    ++tried_[kind];
    if (own.exitCode != 0 && own.exitCode != 1)
      find(kind, "exit code " + std::to_string(own.exitCode) + " " + own.errors);
    if (!pair.isTrapped()) {
      if (own.exitCode == 0) ++left_;
      if (own.exitCode != 0 && !options_.open) find(kind, "is refused: " + own.output.substr(0, 600) + own.errors);
      return;
    }
    if (own.exitCode == 0) find(kind, "leaves with what the judge allows");
    for (const double allowance : {1e-3 * pair.fit + 2e-6, 1.1e-3 * pair.lip}) {
      for (const bool yields : {false, true}) {
        ++tried_[kind];
        const ChildEnd end = check(writePath("stated.json", allowance, yields));
        if (end.exitCode == 1) continue;
        std::ostringstream what;
        what << "exit code " << end.exitCode << " with a stated allowance of " << allowance * 1e3 << " mm"
             << (yields ? " of the block " : " ") << end.errors;
        find(kind, what.str());
      }
    }
  }

  void plan() {
    ++tried_["planned"];
    const ChildEnd end = runCli({"plan", scenario(), "--strategy", "auto", "--time-limit", kPlanSeconds, "--seed", "1",
                                 "--out", folder_ + "/planned.json"});
    if (end.exitCode == 0) find("planned", "the planner finds a way out");
  }

  /// Checks that the exact solids of a trapped pair share a volume when the flange is in the lip. The position of the
  /// body in the lip depends on its shape: a dovetail is as wide as the lip only near its bottom, and meets a thin lip
  /// just before it leaves. So the check tries several positions.
  void checkVolume(const TrappedPair& pair) {
    ++tried_["volumes"];
    bool shared = false;
    for (const double share : {0.999, 0.99, 0.9, 0.6, 0.3})
      shared = shared || commonVolume(pair, share * pair.top) > 0.0;
    if (pair.isTrapped() && !shared) find("volumes", "the exact solids share nothing in the lip");
  }

  const TrappedOptions& options_;
  std::string folder_;
  std::string name_;
  std::map<std::string, std::uint64_t> tried_;
  std::map<std::string, std::uint64_t> defects_;
  std::uint64_t found_ = 0;
  std::uint64_t left_ = 0;  ///< free parts
  bool isSecond_ = false;   ///< whether the next body is the second one of its pair
};

}  // namespace

int runTrapped(const TrappedOptions& options) { return Trapped(options).run(); }

}  // namespace glissade::oracle
