// Checks that engine/RECIPES.md names what exists, and that every recipe is carried out by a test beside this one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "engine/planning/automatic/member.h"
#include "engine/planning/planner.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

std::string documentText(const std::string& file) { return test::readWhole(test::sourceDirectory() + "/" + file); }

std::vector<std::smatch> matchesIn(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

/// The names of a text: words of letters, digits and "_" with three characters or more.
void addNames(const std::string& text, std::set<std::string>& names) {
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto from = text.begin(); from != text.end();) {
    const auto begin = std::find_if(from, text.end(), isPart);
    from = std::find_if_not(begin, text.end(), isPart);
    if (from - begin >= 3) names.emplace(begin, from);
  }
}

/// The files of the project by their path from its folder, and all names in its sources.
struct ProjectFiles {
  ProjectFiles() {
    const fs::path root = test::sourceDirectory();
    for (const char* folder : {"app", "engine", "packaging", "resources", "tests", "widgets"}) {
      paths.emplace_back(folder);
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string path = fs::relative(entry.path(), root).generic_string();
        paths.push_back(path);
        const auto ending = entry.path().extension();
        const bool isSource = ending == ".h" || ending == ".cpp" || ending == ".json";
        if (isSource && path != "tests/recipes/recipes_document_test.cpp") {
          addNames(test::readWhole(entry.path().string()), names);
        }
      }
    }
  }

  /// Paths that are this one or end with it.
  std::vector<std::string> endingWith(const std::string& path) const {
    std::vector<std::string> found;
    std::copy_if(paths.begin(), paths.end(), std::back_inserter(found),
                 [&](const std::string& each) { return each == path || each.ends_with("/" + path); });
    return found;
  }

  std::vector<std::string> paths;
  std::set<std::string> names;
};

/// "a.{h,cpp}" as "a.h" and "a.cpp".
std::vector<std::string> withoutBraces(const std::string& path) {
  const std::size_t open = path.find(".{h,cpp}");
  if (open == std::string::npos) return {path};
  return {path.substr(0, open) + ".h", path.substr(0, open) + ".cpp"};
}

bool isPath(const std::string& code) {
  static const std::regex pattern(R"([A-Za-z0-9_/.-]+(\.(h|cpp|md|txt|json|qrc|sh|svg|ts|\{h,cpp\})|/))");
  return std::regex_match(code, pattern);
}

/// The texts in backticks.
std::vector<std::string> codeIn(const std::string& document) {
  static const std::regex pattern("`([^`]+)`");
  std::vector<std::string> code;
  for (const std::smatch& match : matchesIn(document, pattern)) code.push_back(match[1]);
  return code;
}

class RecipesDocument : public testing::Test {
 protected:
  static void SetUpTestSuite() { files = std::make_unique<ProjectFiles>(); }
  static void TearDownTestSuite() { files.reset(); }

  inline static std::unique_ptr<ProjectFiles> files;
  const std::string recipes = documentText("engine/RECIPES.md");
};

TEST_F(RecipesDocument, FilesExist) {
  int seen = 0;
  for (const std::string& code : codeIn(recipes)) {
    if (!isPath(code)) continue;
    for (std::string path : withoutBraces(code)) {
      ++seen;
      if (path.ends_with("/")) path.pop_back();
      // The reader writes this file, so only its folder exists.
      for (const char* own : {"NAME", "FEATURE", "ID"}) {
        while (path.find(own) != std::string::npos) path = path.substr(0, path.rfind('/'));
      }
      EXPECT_FALSE(files->endingWith(path).empty()) << path;
    }
  }
  EXPECT_GT(seen, 50);
}

TEST_F(RecipesDocument, NamesExist) {
  std::set<std::string> names;
  for (const std::string& code : codeIn(recipes)) {
    if (!isPath(code)) addNames(code, names);
  }
  EXPECT_GT(names.size(), 80U);
  for (const std::string& name : names) EXPECT_TRUE(files->names.count(name)) << name << " is nowhere in the sources";
}

/// "`name` (`file`)", "`name` in `file`", "`name` of `file`".
TEST_F(RecipesDocument, NamesAreInTheStatedFiles) {
  static const std::regex pattern(R"re(`([^`]+)`(?: \(| in | of )`([^`]+\.(?:h|cpp|\{h,cpp\}))`)re");
  int seen = 0;
  for (const std::smatch& match : matchesIn(recipes, pattern)) {
    static const std::regex text("\"[^\"]*\"");
    std::set<std::string> names;
    addNames(std::regex_replace(match[1].str(), text, ""), names);
    std::set<std::string> inFiles;
    for (const std::string& path : withoutBraces(match[2])) {
      for (const std::string& file : files->endingWith(path)) addNames(documentText(file), inFiles);
    }
    for (const std::string& name : names) EXPECT_TRUE(inFiles.count(name)) << name << " is not in " << match[2];
    ++seen;
  }
  EXPECT_GE(seen, 15);
}

/// The place of a heading in its page: "Add a joint kind" is "add-a-joint-kind".
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return anchor;
}

std::vector<std::string> headingsOf(const std::string& document) {
  static const std::regex pattern("\n## ([^\n]+)");
  std::vector<std::string> headings;
  for (const std::smatch& match : matchesIn(document, pattern)) headings.push_back(match[1]);
  return headings;
}

TEST_F(RecipesDocument, EveryRecipeIsCarriedOut) {
  std::string tests;
  for (const auto& entry : fs::directory_iterator(test::sourceDirectory() + "/tests/recipes")) {
    tests += test::readWhole(entry.path().string());
  }
  const std::vector<std::string> headings = headingsOf(recipes);
  EXPECT_GE(headings.size(), 10U);
  for (const std::string& heading : headings) {
    EXPECT_NE(tests.find("recipe \"" + heading + "\""), std::string::npos) << "no test for \"" << heading << '"';
  }
}

TEST_F(RecipesDocument, LinksToRecipesLeadToThem) {
  std::set<std::string> anchors;
  for (const std::string& heading : headingsOf(recipes)) anchors.insert(anchorOf(heading));
  static const std::regex outside(R"(RECIPES\.md#([a-z-]+)\))");
  static const std::regex inside(R"(\]\(#([a-z-]+)\))");
  std::vector<std::string> links;
  for (const std::smatch& match : matchesIn(recipes, inside)) links.push_back(match[1]);
  for (const std::string& path : files->paths) {
    if (!path.ends_with(".md")) continue;
    const std::string text = documentText(path);
    for (const std::smatch& match : matchesIn(text, outside)) links.push_back(match[1]);
  }
  EXPECT_GE(links.size(), 3U);
  for (const std::string& link : links) EXPECT_TRUE(anchors.count(link)) << link;
}

/// The section of a document from a heading to the next one.
std::string sectionOf(const std::string& document, const std::string& heading) {
  const std::size_t begin = document.find("\n## " + heading + "\n");
  if (begin == std::string::npos) return {};
  return document.substr(begin, document.find("\n## ", begin + 1) - begin);
}

TEST(RecipesTables, TheTableOfAlphaHasEveryStrategy) {
  const std::string section = sectionOf(documentText("engine/planning/README.md"), "Where α is used");
  for (const std::string& id : idsOf(makePlannerRegistry())) {
    const std::string cell = id.starts_with("ompl-") ? "`ompl-…`" : "`" + id + "`";
    EXPECT_NE(section.find(cell), std::string::npos) << id;
  }
}

TEST(RecipesTables, TheTableOfMembersHasEveryMember) {
  const std::string page = documentText("engine/planning/automatic/README.md");
  for (const Member& member : makeMembers(windowProblem())) {
    EXPECT_NE(page.find("`" + member.name + "`"), std::string::npos) << member.name;
  }
}

/// Checks the recipe "Add a panel": each panel has its section in both manuals, each folder of a feature is built.
TEST(RecipesTables, EveryPanelIsInBothManualsAndEveryFeatureIsBuilt) {
  const std::string window = documentText("app/window/main_window.cpp");
  static const std::regex panel(R"re(docks_\.add\(\s*\{"[a-z]+", tr\("[^"]+"\), "([a-z-]+)")re");
  const auto panels = matchesIn(window, panel);
  EXPECT_GE(panels.size(), 12U);
  for (const std::string language : {"en", "fr"}) {
    const std::string page = documentText("resources/manual/" + language + "/panels.md");
    for (const std::smatch& match : panels) {
      const std::string id = match[1];
      EXPECT_NE(page.find("## {panel:" + id + "} {#panel-" + id + "}"), std::string::npos) << language << ": " << id;
    }
  }
  std::set<std::string> built;
  addNames(documentText("widgets/CMakeLists.txt"), built);
  for (const auto& entry : fs::directory_iterator(test::sourceDirectory() + "/widgets")) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(built.count(entry.path().filename().string())) << entry.path();
  }
}

}  // namespace
}  // namespace glissade
