// Checks which module of the engine may use which, from the include directives.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string from;  ///< file, relative to the project
  std::string what;  ///< as written between quotes or brackets
};

std::vector<Include> includesUnder(const std::string& folder) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  const fs::path root = test::sourceDirectory();
  std::vector<Include> result;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    std::ifstream stream(entry.path());
    std::string line;
    std::smatch match;
    while (std::getline(stream, line)) {
      if (std::regex_search(line, match, pattern)) {
        result.push_back({fs::relative(entry.path(), root).generic_string(), match[1]});
      }
    }
  }
  return result;
}

/// The module of a file: "planning" for "engine/planning/contact/x.h".
std::string moduleOf(const std::string& path) {
  static const std::regex pattern(R"(^engine/([a-z]+)/)");
  std::smatch match;
  return std::regex_search(path, match, pattern) ? match[1].str() : "";
}

const std::map<std::string, std::set<std::string>>& allowedModules() {
  static const std::map<std::string, std::set<std::string>> allowed{
      {"base", {}},
      {"geometry", {"base"}},
      {"model", {"base", "geometry"}},
      {"import", {"base", "geometry", "model"}},
      {"evidence", {"base", "geometry", "model"}},
      {"check", {"base", "geometry", "model", "import", "evidence"}},
      {"places", {"base", "geometry", "model"}},
      {"collision", {"base", "geometry", "model", "evidence", "places"}},
      {"fits", {"base", "geometry", "model", "evidence", "places", "collision"}},
      {"sweep", {"base", "geometry", "model", "places", "collision"}},
      {"planning", {"base", "geometry", "model", "places", "collision", "fits"}},
      {"operator", {"base", "geometry", "model", "places", "collision"}},
      {"sequence", {"base", "geometry", "model", "evidence", "places", "collision", "fits", "planning"}},
      {"access", {"base", "geometry", "model", "places", "collision", "fits", "planning", "sequence"}},
      {"files",
       {"base", "geometry", "model", "import", "evidence", "check", "places", "collision", "fits", "planning",
        "sequence", "operator", "sweep"}},
      {"session", {"base", "geometry", "model", "places", "collision", "planning", "operator"}},
      {"documents", {"base", "geometry", "model", "fits", "planning", "sequence", "files"}},
      {"study", {"base", "planning", "sequence", "operator", "files"}},
      {"api",
       {"base", "geometry", "model", "import", "evidence", "check", "places", "collision", "fits", "planning",
        "sequence", "operator", "sweep", "session", "files"}},
      {"python", {}},
  };
  return allowed;
}

/// Collects the engine headers that a file includes, directly and indirectly.
void follow(const std::string& file, std::set<std::string>& seen) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*"(engine/[^"]+)")re");
  std::ifstream stream(fs::path(test::sourceDirectory()) / file);
  ASSERT_TRUE(stream.good()) << file;
  std::string line;
  std::smatch match;
  while (std::getline(stream, line)) {
    if (std::regex_search(line, match, pattern) && seen.insert(match[1]).second) follow(match[1], seen);
  }
}

/// The judge of plans shares no code with their planners, directly or through the headers of other modules.
TEST(Architecture, TheJudgeReachesNothingOfThePlanners) {
  const std::set<std::string> allowed{"check", "evidence", "base", "geometry", "model", "import"};
  std::size_t files = 0;
  std::set<std::string> reached;
  for (const auto& entry : fs::directory_iterator(fs::path(test::sourceDirectory()) / "engine/check")) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    ++files;
    follow("engine/check/" + entry.path().filename().string(), reached);
  }
  EXPECT_GT(files, 20U);
  EXPECT_GT(reached.size(), 30U);
  for (const std::string& header : reached) EXPECT_TRUE(allowed.count(moduleOf(header))) << header;
}

TEST(Architecture, EngineModulesOnlyUseTheModulesBelowThem) {
  int seen = 0;
  for (const Include& include : includesUnder("engine")) {
    const std::string from = moduleOf(include.from);
    const std::string to = moduleOf(include.what);
    if (to.empty() || to == from) continue;
    ++seen;
    ASSERT_TRUE(allowedModules().count(from)) << "a module without rules: " << include.from;
    EXPECT_TRUE(allowedModules().at(from).count(to)) << include.from << " includes " << include.what;
  }
  EXPECT_GT(seen, 10);
}

/// Programs are compiled with the public headers alone. The header for OMPL is only for programs that include it.
TEST(Architecture, PublicHeadersIncludeTheStandardAndEigenOnly) {
  static const std::regex allowed(R"(^([a-z_]+|Eigen/[A-Za-z]+|glissade/[a-z_]+\.h)$)");
  static const std::regex ofOmpl(R"(^ompl/[A-Za-z0-9/]+\.h$)");
  const std::string forOmpl = "glissade/ompl.h";
  int seen = 0;
  for (const Include& include : includesUnder("engine/api/include")) {
    ++seen;
    const bool mayUseOmpl = include.from.ends_with(forOmpl) && std::regex_match(include.what, ofOmpl);
    EXPECT_TRUE(mayUseOmpl || std::regex_match(include.what, allowed)) << include.from << " includes " << include.what;
    EXPECT_NE(include.what, forOmpl) << include.from;
  }
  EXPECT_GT(seen, 30);
}

/// Members of Eigen's types that are aligned have another layout in a program for another processor.
TEST(Architecture, PublicHeadersNameNoAlignedTypeOfEigen) {
  static const std::regex aligned(
      R"(Eigen::(?!DontAlign|Matrix<double, 3, 1, Eigen::DontAlign>|Quaternion<double, Eigen::DontAlign>))");
  const fs::path folder = fs::path(test::sourceDirectory()) / "engine/api/include/glissade";
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    ++seen;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      EXPECT_FALSE(std::regex_search(line, aligned)) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(seen, 10);
}

/// The submodule of a file: "contact" for "engine/planning/contact/x.h"; "" for a file of the module itself.
std::optional<std::string> submoduleOf(const std::string& path) {
  static const std::regex pattern(R"(^engine/planning/(?:([a-z]+)/)?[^/]+$)");
  std::smatch match;
  if (!std::regex_search(path, match, pattern)) return std::nullopt;
  return match[1].str();
}

/// Every submodule may use the module itself, which uses no submodule.
const std::map<std::string, std::set<std::string>>& allowedPlanningSubmodules() {
  static const std::map<std::string, std::set<std::string>> allowed{
      {"", {}},
      {"contact", {}},
      {"ompl", {}},
      {"smoothing", {}},
      {"coarse", {"contact"}},
      {"fine", {"coarse", "contact"}},
      {"automatic", {"fine", "contact", "ompl"}},
      {"difficulty", {"automatic"}},
      {"interactive", {"automatic", "fine", "coarse", "contact"}},
  };
  return allowed;
}

TEST(Architecture, PlanningSubmodulesOnlyUseTheModulesBelowThem) {
  const std::string registry = "engine/planning/planner_registry.cpp";  // names every planner
  int seen = 0;
  for (const Include& include : includesUnder("engine/planning")) {
    const auto from = submoduleOf(include.from);
    const auto to = submoduleOf(include.what);
    ASSERT_TRUE(from && allowedPlanningSubmodules().count(*from)) << "a module without rules: " << include.from;
    if (!to || to->empty() || to == from || include.from == registry) continue;
    ++seen;
    EXPECT_TRUE(allowedPlanningSubmodules().at(*from).count(*to)) << include.from << " includes " << include.what;
  }
  EXPECT_GT(seen, 10);
}

TEST(Architecture, TheEngineKnowsNeitherQtNorOsgNorTheWindow) {
  static const std::regex forbidden(R"(^(Q[A-Z]|Qt|osg|OpenThreads|widgets/|app/))");
  for (const Include& include : includesUnder("engine")) {
    EXPECT_FALSE(std::regex_search(include.what, forbidden)) << include.from << " includes " << include.what;
  }
}

TEST(Architecture, WindowAndWidgetsReachTheLibrariesOfTheEngineOnlyThroughIt) {
  static const std::regex forbidden(R"(^(fcl|assimp|urdf_|urdf/|spnav|SDL)|\.hxx$)");
  for (const std::string folder : {"widgets", "app"}) {
    for (const Include& include : includesUnder(folder)) {
      EXPECT_FALSE(std::regex_search(include.what, forbidden)) << include.from << " includes " << include.what;
    }
  }
}

TEST(Architecture, OnlyTheImportingProcessKnowsOpenCascade) {
  const std::set<std::string> process{"engine/import/confined_step_import.cpp",
                                      "engine/import/brep_parts.cpp",
                                      "engine/import/iges_parts.cpp",
                                      "engine/import/loose_parts.cpp",
                                      "engine/import/loose_parts.h",
                                      "engine/import/step_names.cpp",
                                      "engine/import/step_names.h",
                                      "engine/import/shape_overlaps.cpp",
                                      "engine/import/step_assembly.cpp",
                                      "engine/import/step_assembly.h",
                                      "engine/import/step_edge_polygons.cpp",
                                      "engine/import/step_edge_polygons.h",
                                      "engine/import/step_external_files.cpp",
                                      "engine/import/step_external_files.h",
                                      "engine/import/step_face_boundary.cpp",
                                      "engine/import/step_face_boundary.h",
                                      "engine/import/step_face_check.cpp",
                                      "engine/import/step_face_check.h",
                                      "engine/import/step_face_entities.cpp",
                                      "engine/import/step_face_entities.h",
                                      "engine/import/step_face_mesher.cpp",
                                      "engine/import/step_face_mesher.h",
                                      "engine/import/step_faces.cpp",
                                      "engine/import/step_faces.h",
                                      "engine/import/step_fineness.cpp",
                                      "engine/import/step_fineness.h",
                                      "engine/import/step_healing.cpp",
                                      "engine/import/step_healing.h",
                                      "engine/import/step_healing_notes.cpp",
                                      "engine/import/step_losses.cpp",
                                      "engine/import/step_losses.h",
                                      "engine/import/step_mirrors.cpp",
                                      "engine/import/step_mirrors.h",
                                      "engine/import/step_shape_notes.cpp",
                                      "engine/import/step_shape_notes.h",
                                      "engine/import/step_tessellation.cpp",
                                      "engine/import/step_tessellation.h",
                                      "engine/import/step_measures.cpp",
                                      "engine/import/step_missing_shapes.h",
                                      "engine/import/step_stand_in_shapes.h",
                                      "engine/import/step_missing_shapes.cpp",
                                      "engine/import/step_second_shapes.cpp",
                                      "engine/import/step_stand_in_shapes.cpp",
                                      "engine/import/step_tessellated.cpp",
                                      "engine/import/step_measures.h",
                                      "engine/import/step_validation.cpp",
                                      "engine/import/step_validation.h",
                                      "engine/import/step_validation_notes.cpp",
                                      "engine/import/step_validation_notes.h"};
  static const std::regex openCascade(R"(\.hxx$)");
  int seen = 0;
  for (const Include& include : includesUnder("engine")) {
    if (!std::regex_search(include.what, openCascade)) continue;
    ++seen;
    EXPECT_TRUE(process.count(include.from)) << include.from << " includes " << include.what;
  }
  EXPECT_GT(seen, 10);
}

TEST(Architecture, OnlyOneFileOfTheEngineKnowsSdl) {
  int seen = 0;
  for (const Include& include : includesUnder("engine")) {
    if (include.what.rfind("SDL", 0) != 0) continue;
    ++seen;
    EXPECT_EQ(include.from, "engine/operator/gamepad_reader.cpp");
  }
  EXPECT_GT(seen, 0);
}

TEST(Architecture, WidgetsDoNotKnowTheApplication) {
  for (const Include& include : includesUnder("widgets")) {
    EXPECT_NE(include.what.rfind("app/", 0), 0U) << include.from << " includes " << include.what;
  }
}

/// The folder of a file of the window: "sequence" for "widgets/sequence/x.h".
std::string featureOf(const std::string& path) {
  static const std::regex pattern(R"(^widgets/([a-z0-9]+)/)");
  std::smatch match;
  return std::regex_search(path, match, pattern) ? match[1].str() : "";
}

/// The folders below the features, and what each of them may use.
const std::map<std::string, std::set<std::string>>& sharedFolders() {
  static const std::map<std::string, std::set<std::string>> shared{
      {"controls", {}},
      {"openxr", {"controls", "scene3d"}},
      {"scene3d", {"controls", "openxr"}},
      {"document", {"controls"}},
      {"workbench", {"controls", "scene3d", "openxr", "document"}},
  };
  return shared;
}

/// The headers by which features use each other.
const std::map<std::string, std::set<std::string>>& interfacesOfFeatures() {
  static const std::map<std::string, std::set<std::string>> interfaces{
      {"arrange", {"measure/measure_controller.h", "product/assembly_controller.h"}},
      {"files", {"paths/path_controller.h", "product/part_import.h"}},
      {"headset",
       {"devices/device_settings.h", "measure/measure_controller.h", "run/parameter_sliders.h", "run/strategy_use.h",
        "run/refusal_controller.h", "section/section_controller.h", "sequence/sequence_controller.h"}},
      {"help", {"devices/keyboard_steering.h", "files/sample_scenarios.h", "paths/kept_paths_panel.h"}},
      {"paths", {"film/film_dialog.h", "film/film_job.h", "instruction/report_file.h"}},
      {"run", {"devices/steering_keys.h", "files/file_controller.h", "places/rules_dialog.h"}},
      {"section", {"measure/measure_controller.h"}},
      {"sequence",
       {"film/film_dialog.h", "film/film_job.h", "instruction/instruction_painter.h", "instruction/report_file.h",
        "paths/path_panel.h", "product/part_pictures.h"}},
      {"studies", {"files/file_controller.h", "instruction/report_pdf.h"}},
  };
  return interfaces;
}

TEST(Architecture, FeaturesUseEachOtherThroughNamedInterfaces) {
  int seen = 0;
  for (const Include& include : includesUnder("widgets")) {
    const std::string from = featureOf(include.from);
    const std::string to = featureOf(include.what);
    if (to.empty() || to == from) continue;
    ++seen;
    if (const auto shared = sharedFolders().find(from); shared != sharedFolders().end()) {
      EXPECT_TRUE(shared->second.count(to)) << include.from << " includes " << include.what;
      continue;
    }
    if (sharedFolders().count(to)) continue;
    const auto interfaces = interfacesOfFeatures().find(from);
    const std::string header = include.what.substr(std::string("widgets/").size());
    EXPECT_TRUE(interfaces != interfacesOfFeatures().end() && interfaces->second.count(header))
        << include.from << " includes " << include.what;
  }
  EXPECT_GT(seen, 100);
}

/// The document keeps the scenario; the session keeps what it runs, the view what it draws, the recorder what it
/// records.
TEST(Architecture, NobodyElseKeepsAScenario) {
  const std::set<std::string> holders{"widgets/document/workbench_document.h",
                                      "widgets/document/workbench_document.cpp", "widgets/document/session_bridge.h",
                                      "widgets/document/run_recorder.h", "widgets/scene3d/scene_view_impl.h"};
  static const std::regex member(R"(^ +(std::shared_ptr<const LoadedScenario>|ScenarioPtr) \w+_;)");
  const fs::path root = test::sourceDirectory();
  int seen = 0;
  for (const std::string folder : {"widgets", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (!std::regex_search(line, member)) continue;
        ++seen;
        const std::string file = fs::relative(entry.path(), root).generic_string();
        EXPECT_TRUE(holders.count(file)) << file << ": " << line;
      }
    }
  }
  EXPECT_GT(seen, 2);
}

/// Every new panel adds a line and an include, which do not count.
TEST(Architecture, TheMainWindowStaysSmall) {
  const fs::path window = fs::path(test::sourceDirectory()) / "app/window";
  int lines = 0;
  for (const auto& entry : fs::directory_iterator(window)) {
    if (entry.path().filename().string().rfind("main_window", 0) != 0) continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      const bool isOfAPanel = line.rfind("#include", 0) == 0 || line.find("docks_.add(") != std::string::npos;
      lines += isOfAPanel ? 0 : 1;
    }
  }
  EXPECT_GT(lines, 0);
  EXPECT_LT(lines, 250);
}

TEST(Architecture, SourcesStaySmall) {
  const fs::path root = test::sourceDirectory();
  for (const std::string folder : {"engine", "widgets", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream stream(entry.path());
      const auto lines = std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
      EXPECT_LE(lines, 600) << entry.path();
    }
  }
}

}  // namespace
}  // namespace glissade
