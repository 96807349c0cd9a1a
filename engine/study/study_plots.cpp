#include "engine/study/study_plots.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/base/number_text.h"
#include "engine/study/cell_value.h"
#include "engine/study/study_axes.h"

namespace glissade {
namespace {

/// Distance between points of different series at one x, as a share of the axis.
constexpr double kDodge = 0.009;
/// Share of a category's width that its bars take.
constexpr double kBarsShare = 0.84;

/// True for parameters of OMPL's planners. They distinguish series and panels, and are no axis of their own.
bool isOfPeers(ParameterId id) { return id == ParameterId::OmplRange || id == ParameterId::OmplResolution; }

std::vector<ParameterId> variedParameters(const Study& study) {
  std::map<ParameterId, std::set<double>> values;
  for (const StudyCell& cell : study.cells) {
    for (const auto& [id, value] : cell.settings) {
      if (!isLimit(id)) values[id].insert(value);
    }
  }
  std::vector<ParameterId> varied;
  for (const auto& [id, seen] : values) {
    if (seen.size() > 1) varied.push_back(id);
  }
  return varied;
}

std::string titleOf(ParameterId id, const StudyWords& words) {
  const ParameterSpec& spec = specOf(id);
  std::string title = words(spec.label);
  if (!spec.symbol.empty()) title += " " + std::string(spec.symbol);
  if (!spec.unit.empty()) title += " (" + std::string(spec.unit) + ")";
  return title;
}

std::vector<PaperColumn> quantitiesOf(const StudyHeading& heading) {
  std::vector<PaperColumn> columns = heading.paper;
  if (columns.empty()) {
    columns = {{"virtual_s", "Virtual time (s)", {"virtual_s", "median", "solved"}},
               {"nodes", "Nodes", {"nodes", "median", "solved"}},
               {"random_configurations", "Random configurations", {"random_configurations", "median", "solved"}}};
  }
  const auto isSuccess = [](const PaperColumn& column) { return column.quantity.measure == "success_rate"; };
  if (std::none_of(columns.begin(), columns.end(), isSuccess)) {
    columns.push_back({"success_rate", "Success rate", {"success_rate", "", ""}});
  }
  return columns;
}

template <class Get>
bool differ(const Study& study, Get get) {
  return std::any_of(study.cells.begin(), study.cells.end(),
                     [&](const StudyCell& cell) { return get(cell) != get(study.cells.front()); });
}

/// One value of the resolution at which OMPL's planners check edges. Cells without a value are in every panel. Nothing:
/// all cells.
using Panel = std::optional<double>;

std::vector<Panel> panelsOf(const Study& study) {
  std::set<double> values;
  for (const StudyCell& cell : study.cells) {
    const auto setting = cell.settings.find(ParameterId::OmplResolution);
    if (setting != cell.settings.end()) values.insert(setting->second);
  }
  if (values.size() < 2) return {Panel()};
  return {values.rbegin(), values.rend()};
}

/// Makes the plots of one study over one parameter, or over scenarios.
class Plotter {
 public:
  Plotter(const Study& study, const std::vector<CellSummary>& summaries, std::optional<ParameterId> along, Panel panel,
          const StudyWords& words)
      : study_(study),
        summaries_(summaries),
        words_(words),
        along_(along),
        panel_(panel),
        severalStrategies_(differ(study, [](const StudyCell& cell) { return cell.strategy; })),
        severalScenarios_(differ(study, [](const StudyCell& cell) { return cell.scenario; })) {
    for (const StudyCell& cell : study.cells) {
      const std::string name = scenarioName(cell.scenario);
      if (std::find(scenarios_.begin(), scenarios_.end(), name) == scenarios_.end()) scenarios_.push_back(name);
    }
  }

  Plot plot(const PaperColumn& column) const {
    Plot plot;
    plot.name = column.key + (along_ ? "-over-" + std::string(specOf(*along_).key) : "") +
                (panel_ ? "-at-" + toText(*panel_) : "");
    plot.kind = along_ ? PlotKind::Lines : PlotKind::Bars;
    plot.title = along_ ? words_(GLISSADE_TEXT("%1 over %2"), {words_(column.title), words_(specOf(*along_).label)})
                        : words_(GLISSADE_TEXT("%1 over scenario and strategy"), {words_(column.title)});
    if (panel_) plot.title += words_(GLISSADE_TEXT(", OMPL's edges looked at every %1 %"), {toText(100.0 * *panel_)});
    plot.caption = captionOf(column.quantity);
    addOurs(column, plot);
    if (plot.kind == PlotKind::Bars) spreadBars(plot);
    addPaper(column, plot);
    if (plot.kind == PlotKind::Lines) spreadLines(plot);
    setScales(column, plot);
    return plot;
  }

 private:
  static bool isShare(const PaperColumn& column) { return column.quantity.measure == "success_rate"; }

  std::string captionOf(const Quantity& quantity) const {
    std::string text = describe(quantity, words_);
    text.front() = static_cast<char>(std::toupper(text.front()));
    const bool share = quantity.measure == "success_rate";
    text = words_(share ? GLISSADE_TEXT("%1, with Wilson's 95 % interval.") : GLISSADE_TEXT("%1, with quartiles."),
                  {text});
    if (!along_ && !share) text += " " + words_(GLISSADE_TEXT("Above each bar: success rate in %."));
    for (const StudyCell& cell : study_.cells) {
      if (along_ && cell.settings.count(*along_) == 0) {
        text += " " + words_(GLISSADE_TEXT("Not on this axis: %1."), {cell.label});
      }
    }
    return text;
  }

  bool isInPanel(const StudyCell& cell) const {
    const auto setting = cell.settings.find(ParameterId::OmplResolution);
    return !panel_ || setting == cell.settings.end() || setting->second == *panel_;
  }

  /// Position of a cell along x; nothing where it does not set the parameter.
  std::optional<double> xOf(const StudyCell& cell) const {
    if (!along_) {
      const auto found = std::find(scenarios_.begin(), scenarios_.end(), scenarioName(cell.scenario));
      return static_cast<double>(found - scenarios_.begin());
    }
    const auto found = cell.settings.find(*along_);
    if (found == cell.settings.end()) return std::nullopt;
    return found->second;
  }

  std::string seriesName(const StudyCell& cell) const {
    std::string text;
    if (severalStrategies_) appendPart(text, cell.strategy);
    if (cell.operatorName != "none") appendPart(text, cell.operatorName);
    if (along_ && severalScenarios_) appendPart(text, scenarioName(cell.scenario));
    for (const ParameterId id : variedParameters(study_)) {
      const auto setting = cell.settings.find(id);
      if (id != along_ && id != ParameterId::OmplResolution && setting != cell.settings.end()) {
        appendPart(text, std::string(specOf(id).key) + " " + shortNumber(setting->second));
      }
    }
    return text.empty() ? "Glissade" : text;
  }

  static PlotSeries& seriesNamed(const std::string& name, Plot& plot) {
    const auto found = std::find_if(plot.series.begin(), plot.series.end(),
                                    [&](const PlotSeries& series) { return series.name == name; });
    if (found != plot.series.end()) return *found;
    plot.series.emplace_back();
    plot.series.back().name = name;
    plot.series.back().style = (plot.series.size() - 1) % kPlotStyleCount;
    return plot.series.back();
  }

  void addOurs(const PaperColumn& column, Plot& plot) const {
    for (std::size_t i = 0; i < study_.cells.size(); ++i) {
      const auto x = xOf(study_.cells[i]);
      if (!x || !isInPanel(study_.cells[i])) continue;
      PlotSeries& series = seriesNamed(seriesName(study_.cells[i]), plot);
      const auto value = valueOf(summaries_[i], column.quantity);
      if (!value) continue;
      const double unit = isShare(column) ? 100.0 : 1.0;
      PlotPoint point{*x, unit * value->value, unit * value->low, unit * value->high, "", saysOf(i, column, *value), i};
      if (!along_ && !isShare(column)) point.mark = shortNumber(std::round(100.0 * summaries_[i].success.share));
      series.points.push_back(std::move(point));
    }
    for (PlotSeries& series : plot.series) {
      std::stable_sort(series.points.begin(), series.points.end(),
                       [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
    }
  }

  std::string saysOf(std::size_t cell, const PaperColumn& column, const CellValue& value) const {
    const auto show = [&](double number) { return isShare(column) ? percent(number) : shortNumber(number); };
    const CellSummary& summary = summaries_[cell];
    return words_(GLISSADE_TEXT("%1: %2 (%3 to %4), %5 of %6 solved"),
                  {study_.cells[cell].label, show(value.value), show(value.low), show(value.high),
                   std::to_string(summary.solved()), std::to_string(summary.runs)});
  }

  /// Adds the paper's numbers as one series for each strategy: the paper prints one number for a row, for all
  /// operators.
  void addPaper(const PaperColumn& column, Plot& plot) const {
    std::map<std::string, std::size_t> seriesOf;
    std::set<std::string> seen;
    for (const StudyCell& cell : study_.cells) {
      const auto x = xOf(cell);
      const auto found = cell.paper.find(column.key);
      const double* number = found == cell.paper.end() ? nullptr : std::get_if<double>(&found->second);
      if (number == nullptr || !x || !seen.insert(cell.row + "/" + cell.strategy + "/" + cell.scenario).second)
        continue;
      const auto [entry, isNew] = seriesOf.emplace(cell.strategy, plot.series.size());
      if (isNew) plot.series.push_back(paperSeries(cell, plot));
      const double value = isShare(column) ? 100.0 * *number : *number;
      const std::string shown = isShare(column) ? percent(*number) : shortNumber(*number);
      plot.series[entry->second].points.push_back(
          {*x, value, value, value, "", words_(GLISSADE_TEXT("%1, paper: %2"), {cell.row, shown}), {}});
    }
    for (auto& [strategy, index] : seriesOf) {
      auto& points = plot.series[index].points;
      std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    }
  }

  PlotSeries paperSeries(const StudyCell& cell, const Plot& plot) const {
    PlotSeries series;
    series.ofPaper = true;
    series.name = words_(GLISSADE_TEXT("paper"));
    if (along_) return series;
    const std::string beside = seriesName(cell);
    for (const PlotSeries& ours : plot.series) {
      if (!ours.ofPaper && ours.name == beside) series.offset = ours.offset;
    }
    return series;
  }

  void spreadBars(Plot& plot) const {
    const double category = 1.0 / static_cast<double>(scenarios_.size());
    plot.barWidth = kBarsShare * category / static_cast<double>(std::max<std::size_t>(plot.series.size(), 1));
    spread(plot, plot.barWidth);
  }

  static void spreadLines(Plot& plot) { spread(plot, kDodge); }

  static void spread(Plot& plot, double step) {
    const double middle = (static_cast<double>(plot.series.size()) - 1.0) / 2.0;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
      plot.series[i].offset = (static_cast<double>(i) - middle) * step;
    }
  }

  void setScales(const PaperColumn& column, Plot& plot) const {
    std::vector<double> xs;
    std::vector<double> ys;
    for (const PlotSeries& series : plot.series) {
      for (const PlotPoint& point : series.points) {
        xs.push_back(point.x);
        for (const double y : {point.y, point.low, point.high}) ys.push_back(y);
      }
    }
    plot.x = along_ ? PlotScale::fitting(titleOf(*along_, words_), xs)
                    : PlotScale::categories(words_(GLISSADE_TEXT("Scenario")), scenarios_);
    if (isShare(column)) {
      plot.y = PlotScale::percentages(words_(column.title) + " (%)");
    } else {
      // Values are counts of runs and never negative. Zeros have no place on a logarithmic axis.
      ys.erase(std::remove(ys.begin(), ys.end(), 0.0), ys.end());
      // Bars start at a power of ten below all of them.
      if (!along_ && !ys.empty())
        ys.push_back(std::pow(10.0, std::floor(std::log10(*std::min_element(ys.begin(), ys.end())))));
      const std::string title = words_(column.title);
      plot.y = along_ ? PlotScale::fitting(title, ys) : PlotScale::logarithmic(title, ys);
    }
  }

  const Study& study_;
  const std::vector<CellSummary>& summaries_;
  const StudyWords& words_;
  std::optional<ParameterId> along_;
  Panel panel_;
  bool severalStrategies_;
  bool severalScenarios_;
  std::vector<std::string> scenarios_;
};

}  // namespace

std::vector<Plot> plotsOf(const Study& study, const std::vector<CellSummary>& summaries, const StudyWords& words) {
  std::vector<std::optional<ParameterId>> axes;
  for (const ParameterId id : variedParameters(study)) {
    if (!isOfPeers(id)) axes.emplace_back(id);
  }
  if (axes.empty()) axes.emplace_back();
  std::vector<Plot> plots;
  for (const auto& along : axes) {
    for (const Panel& panel : panelsOf(study)) {
      const Plotter plotter(study, summaries, along, panel, words);
      for (const PaperColumn& column : quantitiesOf(study.heading)) plots.push_back(plotter.plot(column));
    }
  }
  return plots;
}

}  // namespace glissade
