#include "app/window/study_script.h"

#include <QTabWidget>

#include <array>

#include "app/window/study_batch.h"
#include "app/window/study_controller.h"
#include "engine/base/number_text.h"
#include "widgets/plots/picture_file.h"
#include "widgets/plots/plot_view.h"
#include "widgets/studies/study_browser.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// From 0; -1 where the word is not a number from 1.
int indexOf(const std::string& word) {
  const auto number = toNumber(word);
  return number ? static_cast<int>(*number) - 1 : -1;
}

Outcome selectCell(StudyBrowser& browser, const std::string& word) {
  if (browser.selectCell(indexOf(word))) return Done{};
  return wrongCommand("there is no cell " + word);
}

Outcome selectPlot(StudyBrowser& browser, const std::string& word) {
  auto* plots = browser.findChild<QTabWidget*>();
  const int index = indexOf(word);
  if (index < 0 || index >= plots->count()) return wrongCommand("there is no plot " + word);
  plots->setCurrentIndex(index);
  return Done{};
}

Outcome savePlot(StudyBrowser& browser, const std::string& file) {
  const PlotView* plot = browser.plot();
  if (plot == nullptr) return wrongCommand("no plot is shown", "Open a study.");
  return outcomeOf(plot->save(QString::fromStdString(file)));
}

Outcome saveBrowser(StudyBrowser& browser, const std::string& file) {
  return outcomeOf(savePicture(browser.grab().toImage(), QString::fromStdString(file)));
}

Outcome zoom(StudyBrowser& browser, const Words& words) {
  std::array<double, 4> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto number = toNumber(words[i]);
    if (!number) return wrongCommand("'" + words[i] + "' is not a number");
    corners[i] = *number;
  }
  PlotView* plot = browser.plot();
  if (plot == nullptr) return wrongCommand("no plot is in front");
  plot->zoom(QRectF(QPointF(corners[0], corners[1]), QPointF(corners[2], corners[3])));
  return Done{};
}

Outcome start(StudyController& studies, const std::string& cell, const std::string& seed) {
  const StudyBrowser& browser = *studies.browser();
  const auto cellNumber = toNumber(cell);
  const auto seedNumber = toNumber(seed);
  if (!cellNumber || !seedNumber || *cellNumber < 1.0) return wrongCommand("give the numbers of a cell and a seed");
  const StudyRun run{static_cast<std::size_t>(*cellNumber) - 1, static_cast<std::uint64_t>(*seedNumber)};
  if (browser.results().count(run) == 0)
    return wrongCommand("the study has no run of cell " + cell + " with seed " + seed);
  return outcomeOf(studies.show(run));
}

}  // namespace

void addStudyCommands(const Workbench& bench, StudyController& studies) {
  ScriptCommands& scripts = bench.scripts;
  scripts.add("study", 1,
              [&studies](const Words& words) { return outcomeOf(studies.open(QString::fromStdString(words[0]))); });
  const auto add = [&](const char* name, std::size_t count, auto handler) {
    scripts.add(name, count, [&studies, handler](const Words& words) -> Outcome {
      if (studies.browser() == nullptr) return wrongCommand("no study is open");
      return handler(words);
    });
  };
  add("study-cell", 1, [&studies](const Words& words) { return selectCell(*studies.browser(), words[0]); });
  add("study-plot", 1, [&studies](const Words& words) { return selectPlot(*studies.browser(), words[0]); });
  add("study-zoom", 4, [&studies](const Words& words) { return zoom(*studies.browser(), words); });
  add("study-save-plot", 1, [&studies](const Words& words) { return savePlot(*studies.browser(), words[0]); });
  add("study-screenshot", 1, [&studies](const Words& words) { return saveBrowser(*studies.browser(), words[0]); });
  add("study-run", 2, [&studies](const Words& words) { return start(studies, words[0], words[1]); });
  scripts.add("study-pictures", 1, [&bench, &studies](const Words& words) {
    return outcomeOf(takeStudyPictures(QString::fromStdString(words[0]), bench, studies));
  });
}

}  // namespace glissade
