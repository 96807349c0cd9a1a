#pragma once

#include <array>
#include <string>

#include "engine/files/scenario_io.h"
#include "engine/planning/coarse/scene_knowledge.h"
#include "tests/engine/support/directories.h"

namespace glissade::test {

inline const std::array<const char*, 5>& shapes() {
  static const std::array<const char*, 5> kShapes{"circle", "square", "triangle", "pentagon", "star"};
  return kShapes;
}

/// A scenario of the second paper's shape game: "tight" or "paper-like". Throws where it does not load.
inline LoadedScenario shapeGame(const std::string& preset, const std::string& shape) {
  auto loaded = loadScenario(test::sourceDirectory() + "/samples/shape-game/" + preset + "-" + shape + ".json");
  if (!loaded) throw std::runtime_error(toString(loaded.error()));
  return std::move(*loaded);
}

/// A loaded shape game with its environment model and what fits where.
struct KnownGame {
  LoadedScenario loaded;
  SceneKnowledgePtr knowledge;

  KnownGame(const std::string& preset, const std::string& shape) : loaded(shapeGame(preset, shape)) {
    auto built = buildSceneKnowledge(loaded.problem, loaded.parameters[ParameterId::RequiredClearance]);
    if (!built) throw std::runtime_error(toString(built.error()));
    knowledge = *built;
    loaded.problem.scene.knowledge = knowledge;
  }
  SemanticModel semantics() const { return semanticsOf(loaded.problem, *knowledge, loaded.problem.scene.edits); }
};

/// The place of this name; kNoPlace where there is none.
inline int placeNamed(const SemanticModel& semantics, const std::string& name) {
  for (std::size_t place = 0; place < semantics.placeCount(); ++place) {
    if (semantics.placeName(place) == name) return static_cast<int>(place);
  }
  return kNoPlace;
}

}  // namespace glissade::test
