#include "engine/study/cell_value.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace glissade {
namespace {

const MeasureSummary* find(const std::vector<MeasureSummary>& measures, const std::string& name) {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const MeasureSummary& measure) { return measure.name == name; });
  return found == measures.end() ? nullptr : &*found;
}

std::string fixed(double value, int digits) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  return {buffer.data(), end.ptr};
}

void dropTrailingZeros(std::string& text) {
  if (text.find('.') == std::string::npos) return;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

/// Inserts a narrow no-break space before every third digit from the right.
void separateThousands(std::string& text) {
  const std::size_t first = text.front() == '-' ? 1 : 0;
  const std::size_t point = std::min(text.find('.'), text.size());
  if (point - first < 5) return;
  for (std::size_t i = point; i > first + 3; i -= 3) text.insert(i - 3, "\u202f");
}

}  // namespace

std::optional<CellValue> valueOf(const CellSummary& summary, const Quantity& quantity) {
  if (quantity.measure == "success_rate") {
    if (summary.runs == 0) return std::nullopt;
    return CellValue{summary.success.share, summary.success.low, summary.success.high, summary.runs};
  }
  const MeasureSummary* measure = find(summary.measures, quantity.measure);
  if (measure == nullptr) measure = find(summary.timing, quantity.measure);
  if (measure == nullptr) return std::nullopt;
  const Distribution& sample = quantity.over == "all" ? measure->all : measure->solved;
  if (sample.count == 0) return std::nullopt;
  const double value = quantity.statistic == "mean" ? sample.mean : sample.median;
  return CellValue{value, sample.firstQuartile, sample.thirdQuartile, sample.count};
}

std::string paperText(const StudyCell& cell, const PaperColumn& column) {
  const auto found = cell.paper.find(column.key);
  if (found == cell.paper.end()) return "";
  if (const auto* words = std::get_if<std::string>(&found->second)) return *words;
  const double* number = std::get_if<double>(&found->second);
  if (number == nullptr) return "";
  return column.quantity.measure == "success_rate" ? percent(*number) : shortNumber(*number);
}

std::string describe(const Quantity& quantity, const StudyWords& words) {
  std::string measure = quantity.measure;
  std::replace(measure.begin(), measure.end(), '_', ' ');
  if (quantity.measure == "success_rate") return words(measure);
  const bool ofAll = quantity.over == "all";
  const CatalogueText mean =
      ofAll ? GLISSADE_TEXT("mean of %1 over all runs") : GLISSADE_TEXT("mean of %1 over the solved runs");
  const CatalogueText median =
      ofAll ? GLISSADE_TEXT("median of %1 over all runs") : GLISSADE_TEXT("median of %1 over the solved runs");
  return words(quantity.statistic == "mean" ? mean : median, {words(measure)});
}

std::string shortNumber(double value) {
  const double size = std::abs(value);
  const int digits =
      size >= 100 || size == 0.0 ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 1, 9);
  std::string text = fixed(value, digits);
  dropTrailingZeros(text);
  separateThousands(text);
  return text;
}

std::string percent(double share) { return fixed(100.0 * share, 0) + " %"; }

}  // namespace glissade
