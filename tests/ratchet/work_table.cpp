#include "tests/ratchet/work_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <tuple>

namespace glissade::ratchet {
namespace {

constexpr std::size_t kColumns = 3 + kMeasures.size() + 1;

/// Smaller counts are compared as if they were this large, because they vary by ones without a reason of cost.
constexpr double kSmallest = 100.0;

auto keyOf(const WorkRow& row) { return std::tie(row.family, row.name, row.seed); }

std::string nameOf(const WorkRow& row) { return row.family + " " + row.name + ", seed " + std::to_string(row.seed); }

std::string header() {
  std::string text = "family,case,seed";
  for (const std::string_view measure : kMeasures) text += "," + std::string(measure);
  return text + ",reason";
}

/// The cells of a line; the last cell may contain commas.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t at = 0;
  while (cells.size() + 1 < kColumns) {
    const std::size_t comma = line.find(',', at);
    if (comma == std::string::npos) return {};
    cells.push_back(line.substr(at, comma - at));
    at = comma + 1;
  }
  cells.push_back(line.substr(at));
  return cells;
}

bool readNumber(const std::string& text, std::uint64_t& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end;
}

std::optional<WorkRow> rowOf(const std::vector<std::string>& cells) {
  if (cells.size() != kColumns) return std::nullopt;
  WorkRow row{cells[0], cells[1]};
  if (row.family.empty() || row.name.empty() || !readNumber(cells[2], row.seed)) return std::nullopt;
  for (std::size_t i = 0; i < kMeasures.size(); ++i) {
    if (cells[3 + i].empty()) continue;
    if (!readNumber(cells[3 + i], row.work[i].emplace())) return std::nullopt;
  }
  row.reason = cells.back();
  if (row.reason.empty()) return std::nullopt;
  return row;
}

double ratio(std::uint64_t before, std::uint64_t now) {
  return std::max(static_cast<double>(now), kSmallest) / std::max(static_cast<double>(before), kSmallest);
}

std::string times(double factor) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << factor << " times";
  return text.str();
}

/// Sum of logarithms of ratios, and their number.
struct Mean {
  double logarithms = 0.0;
  int count = 0;

  void add(double factor) {
    logarithms += std::log(factor);
    ++count;
  }
  double value() const { return std::exp(logarithms / count); }
};

}  // namespace

std::string writeTable(std::vector<WorkRow> rows) {
  std::sort(rows.begin(), rows.end(), [](const WorkRow& a, const WorkRow& b) { return keyOf(a) < keyOf(b); });
  std::string text = header() + "\n";
  for (const WorkRow& row : rows) {
    text += row.family + "," + row.name + "," + std::to_string(row.seed);
    for (const auto& value : row.work) text += "," + (value ? std::to_string(*value) : std::string());
    text += "," + row.reason + "\n";
  }
  return text;
}

Result<std::vector<WorkRow>> readTable(const std::string& text, const std::string& file) {
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  const auto malformed = [&](std::size_t number) {
    return Diagnostic{ErrorKind::MalformedInput, file, "line " + std::to_string(number),
                      Message("is not a row of the table of work"),
                      Message("Write the table anew with work_ratchet --record REASON.")};
  };
  if (line != header()) return malformed(1);
  std::vector<WorkRow> rows;
  while (std::getline(in, line)) {
    auto row = rowOf(cellsOf(line));
    if (!row) return malformed(rows.size() + 2);
    rows.push_back(std::move(*row));
  }
  return rows;
}

std::vector<std::string> risen(const std::vector<WorkRow>& before, const std::vector<WorkRow>& now) {
  std::vector<std::string> faults;
  std::map<std::pair<std::string, std::size_t>, Mean> families;
  for (const WorkRow& row : now) {
    const auto old =
        std::find_if(before.begin(), before.end(), [&](const WorkRow& each) { return keyOf(each) == keyOf(row); });
    if (old == before.end()) {
      faults.push_back(nameOf(row) + " has no row");
      continue;
    }
    for (std::size_t i = 0; i < row.work.size(); ++i) {
      const std::string measure(kMeasures[i]);
      if (row.work[i].has_value() != old->work[i].has_value()) {
        faults.push_back(nameOf(row) + ": " + measure + (row.work[i] ? " is new" : " is no longer measured"));
      }
      if (!row.work[i] || !old->work[i]) continue;
      const double factor = ratio(*old->work[i], *row.work[i]);
      families[{row.family, i}].add(factor);
      if (factor > kMostOfCase) {
        faults.push_back(nameOf(row) + ": " + measure + " rose from " + std::to_string(*old->work[i]) + " to " +
                         std::to_string(*row.work[i]) + ", " + times(factor));
      }
    }
  }
  for (const auto& [key, mean] : families) {
    if (mean.value() <= kMostOfFamily) continue;
    faults.push_back("family " + key.first + ": the geometric mean of " + std::string(kMeasures[key.second]) +
                     " rose " + times(mean.value()));
  }
  return faults;
}

std::vector<WorkRow> recorded(const std::vector<WorkRow>& before, const std::vector<WorkRow>& now,
                              const std::string& reason) {
  std::vector<WorkRow> rows = before;
  for (const WorkRow& row : now) {
    auto old = std::find_if(rows.begin(), rows.end(), [&](const WorkRow& each) { return keyOf(each) == keyOf(row); });
    if (old == rows.end()) old = rows.insert(rows.end(), row);
    if (old->work == row.work && !old->reason.empty()) continue;
    old->work = row.work;
    old->reason = reason;
  }
  return rows;
}

}  // namespace glissade::ratchet
