#include "app/window/study_script.h"

#include <QTabWidget>

#include <array>

#include "app/window/study_controller.h"
#include "engine/base/number_text.h"
#include "widgets/plots/plot_view.h"
#include "widgets/studies/study_browser.h"

namespace glissade {
namespace {

Diagnostic wrong(const std::string& reason) { return {ErrorKind::MalformedInput, "", "", reason, ""}; }

Outcome outcomeOf(const std::optional<Diagnostic>& why) { return why ? Outcome(*why) : Outcome(Done{}); }

}  // namespace

std::optional<Outcome> StudyScript::carryOut(const ScriptCommand& command) {
  if (command.name.rfind("study", 0) != 0) return std::nullopt;
  if (command.name == "study") return outcomeOf(window_.studies().open(QString::fromStdString(command.arguments[0])));
  if (window_.studies().browser() == nullptr) return wrong("no study is open");
  if (command.name == "study-run") return start(command.arguments[0], command.arguments[1]);
  if (command.name == "study-zoom") return zoom(command.arguments);
  if (command.name == "study-save-plot") {
    const PlotView* plot = window_.studies().browser()->plot();
    const bool saved = plot != nullptr && plot->save(QString::fromStdString(command.arguments[0]));
    return saved ? Outcome(Done{}) : wrong("the plot cannot be saved");
  }
  return choose(command);
}

Outcome StudyScript::choose(const ScriptCommand& command) {
  StudyBrowser& browser = *window_.studies().browser();
  const std::string& word = command.arguments[0];
  if (command.name == "study-screenshot") {
    const bool saved = browser.grab().save(QString::fromStdString(word));
    return saved ? Outcome(Done{}) : wrong("the picture cannot be saved");
  }
  const auto number = toNumber(word);
  const int index = number ? static_cast<int>(*number) - 1 : -1;
  if (command.name == "study-cell") {
    return browser.selectCell(index) ? Outcome(Done{}) : wrong("there is no cell " + word);
  }
  auto* plots = browser.findChild<QTabWidget*>();
  if (index < 0 || index >= plots->count()) return wrong("there is no plot " + word);
  plots->setCurrentIndex(index);
  return Done{};
}

Outcome StudyScript::zoom(const std::vector<std::string>& words) {
  std::array<double, 4> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto number = toNumber(words[i]);
    if (!number) return wrong("'" + words[i] + "' is not a number");
    corners[i] = *number;
  }
  PlotView* plot = window_.studies().browser()->plot();
  if (plot == nullptr) return wrong("no plot is in front");
  plot->zoom(QRectF(QPointF(corners[0], corners[1]), QPointF(corners[2], corners[3])));
  return Done{};
}

Outcome StudyScript::start(const std::string& cell, const std::string& seed) {
  const StudyBrowser& browser = *window_.studies().browser();
  const auto cellNumber = toNumber(cell);
  const auto seedNumber = toNumber(seed);
  if (!cellNumber || !seedNumber || *cellNumber < 1.0) return wrong("give the numbers of a cell and a seed");
  const StudyRun run{static_cast<std::size_t>(*cellNumber) - 1, static_cast<std::uint64_t>(*seedNumber)};
  if (browser.results().count(run) == 0) return wrong("the study has no run of cell " + cell + " with seed " + seed);
  return outcomeOf(window_.studies().show(run));
}

}  // namespace glissade
