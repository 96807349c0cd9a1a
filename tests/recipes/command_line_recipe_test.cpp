// Checks what the recipe "Add a parameter" says of the command line and of files. Other entries are in its help, too.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/parameters.h"
#include "engine/files/path_exporter.h"
#include "engine/operator/device_registry.h"
#include "engine/planning/planner.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

/// The words of the help of a command.
std::set<std::string> helpWords(const std::string& command) {
  std::string text;
  std::array<char, 4096> buffer{};
  FILE* pipe = ::popen((test::programDirectory() + "/glissade-cli " + command + " --help").c_str(), "r");
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
  EXPECT_EQ(::pclose(pipe), 0);
  std::set<std::string> words;
  std::string word;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0 && std::string_view(",()").find(c) == std::string_view::npos) {
      word += c;
    } else {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

nlohmann::json schemaNamed(const std::string& name) {
  return nlohmann::json::parse(test::readWhole(test::sourceDirectory() + "/resources/schema/" + name + ".schema.json"));
}

TEST(CommandLineRecipe, TheHelpOfPlanHasEveryEntry) {
  const std::set<std::string> words = helpWords("plan");
  for (const ParameterSpec& spec : parameterTable()) EXPECT_TRUE(words.count(std::string(spec.option))) << spec.option;
  for (const std::string& id : idsOf(makePlannerRegistry())) EXPECT_TRUE(words.count(id)) << id;
  DeviceRegistry devices = makeDeviceRegistry();
  addTaskOperators(devices);
  for (const DeviceEntry& entry : devices.entries()) {
    EXPECT_TRUE(words.count(entry.id) || !entry.simulated) << entry.id;
  }
  const PathExporterRegistry exporters = makePathExporterRegistry();
  for (const PathExporter& exporter : exporters.entries()) {
    EXPECT_TRUE(words.count("." + exporter.endings.front())) << exporter.id;
  }
}

TEST(CommandLineRecipe, TheSchemaOfScenariosHasExactlyTheParametersOfTheTable) {
  std::set<std::string> keys;
  for (const ParameterSpec& spec : parameterTable()) keys.insert(std::string(spec.key));
  std::set<std::string> stated;
  const nlohmann::json schema = schemaNamed("scenario-1");
  for (const auto& [key, range] : schema.at("properties").at("parameters").at("properties").items()) stated.insert(key);
  EXPECT_EQ(stated, keys);
}

TEST(CommandLineRecipe, TheSchemaOfStudiesHasEverySimulatedOperator) {
  std::set<std::string> ids{"none"};
  const DeviceRegistry devices = makeDeviceRegistry();
  for (const DeviceEntry& entry : devices.entries()) {
    if (entry.simulated) ids.insert(entry.id);
  }
  const auto schema = schemaNamed("study-1");
  const auto stated = schema.at("properties").at("operators").at("items").at("enum");
  EXPECT_EQ(stated.get<std::set<std::string>>(), ids);
}

}  // namespace
}  // namespace glissade
