// What documents say of the code.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A call that a document names, with the file in which it says it is.
struct NamedCall {
  std::string name;
  std::string file;
};

/// Lines as "1. `Class::method` ... (`folder/file.cpp`)."
std::vector<NamedCall> callsIn(const std::string& document) {
  static const std::regex pattern(R"(\n\d\. `([A-Za-z:]+)`[^\n]*\(`([a-z0-9_/]+\.(?:cpp|h))`\)\.)");
  std::vector<NamedCall> calls;
  for (std::sregex_iterator match(document.begin(), document.end(), pattern), end; match != end; ++match) {
    calls.push_back({(*match)[1], (*match)[2]});
  }
  return calls;
}

TEST(Documents, TheWayOfAClickNamesCallsThatAreThere) {
  const fs::path root = test::sourceDirectory();
  const std::string page = contentOf(root / "engine/README.md");
  EXPECT_EQ(page.find("\n8. `"), std::string::npos) << "a way has at most seven calls";
  const std::vector<NamedCall> calls = callsIn(page);
  EXPECT_GE(calls.size(), 18U);
  for (const NamedCall& call : calls) {
    const std::string code = contentOf(root / call.file);
    EXPECT_FALSE(code.empty()) << call.file;
    const std::string own = call.name.substr(call.name.rfind(':') + 1);
    EXPECT_TRUE(std::regex_search(code, std::regex("\\b" + own + "\\b"))) << call.name << " is not in " << call.file;
  }
}

TEST(Documents, EveryRoomIsInTheArchitecturePage) {
  const fs::path root = test::sourceDirectory();
  const std::string page = contentOf(root / "engine/README.md");
  for (const auto& entry : fs::directory_iterator(root / "engine")) {
    if (!entry.is_directory()) continue;
    EXPECT_NE(page.find("| `" + entry.path().filename().string() + "` |"), std::string::npos) << entry.path();
  }
}

/// Links to files, without those to the web.
TEST(Documents, LinksLeadToFiles) {
  static const std::regex pattern(R"(\]\(([^)#: ]+)(?:#[^)]*)?\))");
  const fs::path root = test::sourceDirectory();
  int seen = 0;
  for (const char* folder : {"engine", "widgets", "app", "packaging", "samples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".md") continue;
      const std::string text = contentOf(entry.path());
      for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        EXPECT_TRUE(fs::exists(entry.path().parent_path() / (*match)[1].str())) << entry.path() << ": " << (*match)[1];
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 10);
}

}  // namespace
}  // namespace glissade
