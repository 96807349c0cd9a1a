#include "app/window/times_script.h"

#include <algorithm>

#include "app/window/times_controller.h"
#include "engine/base/number_text.h"
#include "widgets/studies/times_view.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// The place in workTimeRows(); nothing where no row has this name.
std::optional<std::size_t> rowOf(const std::string& id) {
  const auto& rows = workTimeRows();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const WorkTimeRow& row) { return row.id == id; });
  if (found == rows.end()) return std::nullopt;
  return static_cast<std::size_t>(found - rows.begin());
}

Diagnostic unknownRow(const std::string& id) {
  return wrongCommand("'" + id + "' is no work time", "Take the names that 'times --write-table' writes.");
}

Outcome setTime(TimesView& view, const std::string& id, const std::string& text) {
  const auto row = rowOf(id);
  if (!row) return unknownRow(id);
  view.showTable();
  view.table().write(*row, QString::fromStdString(text));
  return Done{};
}

Outcome expectTime(const WorkTimes& times, const std::string& id, const std::string& expected) {
  const auto row = rowOf(id);
  if (!row) return unknownRow(id);
  const std::string value = toText(times.*workTimeRows()[*row].value);
  if (value == expected) return Done{};
  return unmetExpectation("'" + id + "' is " + value + ", not " + expected);
}

Outcome expectTimes(const TimesView& view, const std::string& what, const std::string& expected) {
  std::string found;
  if (what == "stations") {
    found = std::to_string(view.shownBars());
  } else if (what == "sum") {
    found = QString::number(view.shownSeconds(), 'f', 1).toStdString();
  } else {
    return wrongCommand("'" + what + "' is no number of the times", "Say stations or sum.");
  }
  if (found == expected) return Done{};
  return unmetExpectation("the times have " + what + " " + found + ", not " + expected);
}

}  // namespace

void addTimesCommands(const Workbench& bench, TimesController& times) {
  bench.scripts.add("times", 1, [&times](const Words& words) -> Outcome {
    times.show();
    times.view().setStations(QString::fromStdString(words[0]).toInt());
    return Done{};
  });
  bench.scripts.add("expect-times", 2,
                    [&times](const Words& words) { return expectTimes(times.view(), words[0], words[1]); });
  bench.scripts.add("set-time", 2, [&times](const Words& words) { return setTime(times.view(), words[0], words[1]); });
  bench.scripts.add("expect-time", 2,
                    [&times](const Words& words) { return expectTime(times.table().times(), words[0], words[1]); });
  bench.scripts.add("open-times", 1, [&times](const Words& words) {
    return outcomeOf(times.openTable(QString::fromStdString(words[0])));
  });
  bench.scripts.add("save-times", 1, [&times](const Words& words) {
    return outcomeOf(times.saveTable(QString::fromStdString(words[0])));
  });
}

}  // namespace glissade
