// Removes, renames or replaces one entity of a valid STEP file: a missing body has to be named, or the file refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <regex>

#include "engine/base/random_stream.h"
#include "engine/import/step_import.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/step_files/step_text.h"

namespace glissade {
namespace {

using test::StepText;

/// Assemblies in two levels, faceted and tessellated bodies, another unit, two solids in a part, and no curve.
std::string mixedAssembly() {
  StepText text;
  StepText::Product assembly = text.part("assembly", "");
  StepText::Product inner = text.part("inner", "");
  const auto box = text.part("box", text.box({0, 0, 0}, {1, 2, 3}), "FACETED_BREP_SHAPE_REPRESENTATION");
  const auto twins = text.part("twins", text.box({0, 0, 0}, {1, 1, 1}) + "," + text.box({3, 0, 0}, {2, 1, 1}));
  const auto mesh = text.part("mesh", text.tessellatedBox({0, 0, 0}, {1, 1, 1}), "TESSELLATED_SHAPE_REPRESENTATION");
  const auto inch =
      text.part("inch", text.box({0, 0, 0}, {1, 1, 1}), "FACETED_BREP_SHAPE_REPRESENTATION", text.inches());
  text.place(inner, box, {0, 0, 0});
  text.place(inner, mesh, {9, 0, 0}, {0, 1, 0});
  text.place(assembly, inner, {0, 0, 0});
  text.place(assembly, inner, {0, 40, 0}, {1, 0, 0}, {0, 1, 0});
  text.place(assembly, twins, {20, 0, 0});
  text.place(assembly, inch, {50, 0, 0});
  return text.str();
}

/// "#12=…;" of a text that has no ';' elsewhere.
struct EntityText {
  std::string id;
  std::string type;
  std::string all;
};

std::vector<EntityText> entitiesOf(const std::string& text) {
  static const std::regex pattern(R"((#\d+)\s*=\s*(\(?\s*\w+)[^;]*;)");
  std::vector<EntityText> entities;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), pattern); at != std::sregex_iterator(); ++at) {
    entities.push_back({(*at)[1], (*at)[2], (*at)[0]});
  }
  return entities;
}

struct Mutant {
  std::string what;
  std::string text;
};

Mutant mutantOf(const std::string& text, RandomStream& stream) {
  const std::vector<EntityText> entities = entitiesOf(text);
  const auto draw = [&] { return entities[stream.bits() % entities.size()]; };
  const EntityText entity = draw();
  const EntityText other = draw();
  const std::uint64_t kind = stream.bits() % 4;
  std::string changed = entity.all;
  std::string what = "removed";
  if (kind == 0) {
    changed.clear();
  } else if (kind == 1) {
    changed.replace(changed.find(entity.type), entity.type.size(), entity.type + "_X");
    what = "renamed";
  } else if (kind == 2) {
    changed.replace(changed.find(entity.type), entity.type.size(), other.type);
    what = "renamed to " + other.type;
  } else {
    changed = entity.id + other.all.substr(other.all.find('='));
    what = "replaced by " + other.all;
  }
  std::string mutated = text;
  mutated.replace(mutated.find(entity.all), entity.all.size(), changed);
  return {entity.all + " " + what, mutated};
}

/// Number of bodies by the name of their product: the last step of the path, or the one before if that numbers the
/// solids.
std::map<std::string, int> bodiesOf(const StepProduct& product) {
  std::map<std::string, int> counts;
  for (const Occurrence& part : product.parts) {
    std::string path = part.path;
    for (const char* solid : {"/solid", "/surfaces"}) {
      if (const auto at = path.rfind(solid); at != std::string::npos) path.erase(at);
    }
    path.erase(0, path.rfind('/') + 1);
    ++counts[path.substr(0, path.find('#'))];
  }
  return counts;
}

int totalOf(const std::map<std::string, int>& counts) {
  int total = 0;
  for (const auto& [name, count] : counts) total += count;
  return total;
}

/// A body of the valid file that is missing and not named, nor an assembly that contains it; empty: none.
std::string unnamedLoss(const std::map<std::string, int>& sound, const StepProduct& product) {
  const std::map<std::string, int> there = bodiesOf(product);
  if (totalOf(there) >= totalOf(sound)) return {};
  for (const auto& [name, count] : sound) {
    const auto found = there.find(name);
    if (found != there.end() && found->second >= count) continue;
    const bool isNamed =
        std::any_of(product.missing.begin(), product.missing.end(), [&name = name](const MissingShape& shape) {
          return shape.product == name || shape.product.empty() || shape.product == "inner" ||
                 shape.product == "assembly";
        });
    if (!isNamed) return name;
  }
  return {};
}

std::uint64_t numberOf(const char* variable, std::uint64_t otherwise) {
  const char* value = std::getenv(variable);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

TEST(StepShapeMutants, ABodyThatGoesIsNamed) {
  const std::uint64_t mutants = numberOf("GLISSADE_SHAPE_MUTANTS", 24);
  const std::uint64_t seed = numberOf("GLISSADE_SHAPE_SEED", 1);
  const test::TemporaryFolder folder;
  RandomStream stream(seed, "shape mutants");
  const auto begin = std::chrono::steady_clock::now();
  int refused = 0;
  int defects = 0;
  int named = 0;
  for (const std::string& text : {mixedAssembly(), test::stepText("fits.step")}) {
    const auto sound = importStep(folder.write("sound.step", text), 0.0);
    ASSERT_TRUE(sound.ok()) << toString(sound.error());
    ASSERT_TRUE(sound->missing.empty());
    const std::map<std::string, int> bodies = bodiesOf(*sound);
    for (std::uint64_t i = 0; i < mutants / 2; ++i) {
      const Mutant mutant = mutantOf(text, stream);
      const auto product = importStep(folder.write("mutant.step", mutant.text), 0.0);
      if (!product) {
        EXPECT_EQ(product.error().kind, ErrorKind::MalformedInput) << toString(product.error());
        ++refused;
        continue;
      }
      const std::string lost = unnamedLoss(bodies, *product);
      if (!product->missing.empty()) ++named;
      if (lost.empty()) continue;
      ++defects;
      ADD_FAILURE() << "'" << lost << "' is gone without a word: " << mutant.what;
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::cout << "ROW mutants of STEP files, of which " << refused << " are refused and " << named << " name a shape | "
            << mutants << " | " << mutants - static_cast<std::uint64_t>(defects) << " | " << defects << " | "
            << static_cast<int>(seconds.count()) << " | - | " << seed << "\n";
}

}  // namespace
}  // namespace glissade
