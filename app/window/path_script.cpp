#include "app/window/path_script.h"

#include <cmath>

#include "app/window/path_controller.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"

namespace glissade {
namespace {

/// none, a number, or a length with its unit.
Outcome setGhosts(PathController& path, const std::string& word) {
  PathSpacing spacing = path.panel()->ghosts().spacing();
  const auto number = toNumber(word);
  const auto distance = toMetres(word, 1e-3);
  if (word == "none") {
    spacing.by = PathSpacing::By::None;
  } else if (number && *number >= 1 && *number <= kMostPathPoses && *number == std::floor(*number)) {
    spacing.by = PathSpacing::By::Number;
    spacing.number = static_cast<int>(*number);
  } else if (!number && distance && *distance > 0.0) {
    spacing.by = PathSpacing::By::Distance;
    spacing.distance = *distance;
  } else {
    return wrongCommand("these are no ghosts", "Say none, a number, or a length such as 25mm.");
  }
  path.panel()->ghosts().setSpacing(spacing);
  return Done{};
}

}  // namespace

void addPathCommands(ScriptCommands& scripts, PathController& path) {
  using Words = ScriptCommands::Words;
  scripts.add("export", 1,
              [&path](const Words& words) { return outcomeOf(path.exportTo(QString::fromStdString(words[0]))); });
  scripts.add("report-path", 1, [&path](const Words& words) -> Outcome {
    SaveResult result;
    path.reportTo(QString::fromStdString(words[0]), [&result](const SaveResult& saved) { result = saved; });
    return outcomeOf(result);
  });
  scripts.add("film-path", 1, [&path](const Words& words) -> Outcome {
    SaveResult result;
    path.filmTo(QString::fromStdString(words[0]), [&result](const SaveResult& saved) { result = saved; });
    return outcomeOf(result);
  });
  scripts.add("open-path", 1,
              [&path](const Words& words) { return outcomeOf(path.open(QString::fromStdString(words[0]))); });
  scripts.add("expect-path", 1, [&path](const Words& words) -> Outcome {
    const std::string found = path.verdict();
    if (found == words[0]) return Done{};
    return unmetExpectation("the path is '" + found + "', not '" + words[0] + "'");
  });
  scripts.add("ghosts", 1, [&path](const Words& words) { return setGhosts(path, words[0]); });
}

}  // namespace glissade
