// The edges of DESIGN section 2, read from the includes themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace glissade {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string from;  ///< file, relative to the project
  std::string what;  ///< as written between quotes or brackets
};

std::vector<Include> includesUnder(const std::string& folder) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  const fs::path root = GLISSADE_SOURCE_DIR;
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

/// "engine/planning/contact/x.h" lies in room "planning".
std::string roomOf(const std::string& path) {
  static const std::regex pattern(R"(^engine/([a-z]+)/)");
  std::smatch match;
  return std::regex_search(path, match, pattern) ? match[1].str() : "";
}

const std::map<std::string, std::set<std::string>>& allowedRooms() {
  static const std::map<std::string, std::set<std::string>> allowed{
      {"base", {}},
      {"geometry", {"base"}},
      {"import", {"base", "geometry"}},
      {"environment", {"base", "geometry"}},
      {"collision", {"base", "geometry", "environment"}},
      {"planning", {"base", "geometry", "environment", "collision"}},
      {"operator", {"base", "geometry", "environment", "collision"}},
      {"scenario", {"base", "geometry", "import", "environment", "collision", "planning", "operator"}},
      {"session", {"base", "geometry", "environment", "collision", "planning", "operator"}},
      {"study",
       {"base", "geometry", "import", "environment", "collision", "planning", "operator", "scenario", "session"}},
  };
  return allowed;
}

TEST(Architecture, EngineRoomsOnlyUseTheRoomsBelowThem) {
  int seen = 0;
  for (const Include& include : includesUnder("engine")) {
    const std::string from = roomOf(include.from);
    const std::string to = roomOf(include.what);
    if (to.empty() || to == from) continue;
    ++seen;
    ASSERT_TRUE(allowedRooms().count(from)) << "a room without rules: " << include.from;
    EXPECT_TRUE(allowedRooms().at(from).count(to)) << include.from << " includes " << include.what;
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
  const std::set<std::string> process{"engine/import/confined_step_import.cpp", "engine/import/step_assembly.cpp",
                                      "engine/import/step_assembly.h", "engine/import/step_tessellation.cpp",
                                      "engine/import/step_tessellation.h"};
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
  for (const Include& include : includesUnder("engine")) {
    if (include.what.rfind("SDL", 0) != 0) continue;
    EXPECT_EQ(include.from, "engine/operator/gamepad_reader.cpp");
  }
}

TEST(Architecture, WidgetsDoNotKnowTheApplication) {
  for (const Include& include : includesUnder("widgets")) {
    EXPECT_NE(include.what.rfind("app/", 0), 0U) << include.from << " includes " << include.what;
  }
}

TEST(Architecture, SourcesStaySmall) {
  const fs::path root = GLISSADE_SOURCE_DIR;
  for (const std::string folder : {"engine", "widgets", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream stream(entry.path());
      const auto lines = std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
      EXPECT_LE(lines, 500) << entry.path();
    }
  }
}

}  // namespace
}  // namespace glissade
