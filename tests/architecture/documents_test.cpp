// Checks the statements of documents about the code.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
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

/// A call that a document names, with its stated file.
struct NamedCall {
  std::string name;
  std::string file;
};

/// Reads lines of the form "1. `Class::method` ... (`folder/file.cpp`)."
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

TEST(Documents, EveryModuleIsInTheArchitecturePage) {
  const fs::path root = test::sourceDirectory();
  const std::string page = contentOf(root / "engine/README.md");
  for (const auto& entry : fs::directory_iterator(root / "engine")) {
    if (!entry.is_directory()) continue;
    EXPECT_NE(page.find("| `" + entry.path().filename().string() + "` |"), std::string::npos) << entry.path();
  }
}

/// The documents of a folder; for the source folder itself, only the documents directly in it.
std::vector<fs::path> documentsOf(const fs::path& root, const std::string& folder) {
  std::vector<fs::path> documents;
  const auto add = [&documents](const fs::path& file) {
    if (file.extension() == ".md") documents.push_back(file);
  };
  if (folder.empty()) {
    for (const auto& entry : fs::directory_iterator(root)) add(entry.path());
  } else {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) add(entry.path());
  }
  return documents;
}

/// Links to files and pictures, without those to the web. The manual names pages and has its own test.
TEST(Documents, LinksLeadToFiles) {
  static const std::regex pattern(R"(\]\(([^)#: ]+)(?:#[^)]*)?\))");
  const fs::path root = test::sourceDirectory();
  int seen = 0;
  for (const char* folder : {"", "engine", "widgets", "app", "packaging", "samples", "tests"}) {
    for (const fs::path& document : documentsOf(root, folder)) {
      const std::string text = contentOf(document);
      for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        EXPECT_TRUE(fs::exists(document.parent_path() / (*match)[1].str())) << document << ": " << (*match)[1];
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 40);
}

std::size_t wordsOf(const std::string& text) {
  std::istringstream words(text);
  return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(words), {}));
}

TEST(Documents, TheFrontPageIsShort) {
  EXPECT_LE(wordsOf(contentOf(fs::path(test::sourceDirectory()) / "README.md")), 1200U);
}

}  // namespace
}  // namespace glissade
