#include "app/window/path_script.h"

#include "app/window/path_controller.h"

namespace glissade {

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
}

}  // namespace glissade
