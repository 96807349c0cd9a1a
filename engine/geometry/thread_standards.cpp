#include "engine/geometry/thread_standards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>

namespace glissade {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kInch = 25.4e-3;

/// A row of the table of metric threads, millimetres; 0: no nut, no further fine pitch.
struct MetricRow {
  double diameter;
  double coarse;
  double nut;
  std::array<double, 4> fine;
};
constexpr std::array<MetricRow, 39> kMetric{{{1.0, 0.25, 0.0, {0.2}},
                                             {1.1, 0.25, 0.0, {0.2}},
                                             {1.2, 0.25, 0.0, {0.2}},
                                             {1.4, 0.3, 0.0, {0.2}},
                                             {1.6, 0.35, 3.2, {0.2}},
                                             {1.8, 0.35, 0.0, {0.2}},
                                             {2.0, 0.4, 4.0, {0.25}},
                                             {2.2, 0.45, 4.5, {0.25}},
                                             {2.5, 0.45, 5.0, {0.35}},
                                             {3.0, 0.5, 5.5, {0.35}},
                                             {3.5, 0.6, 6.0, {0.35}},
                                             {4.0, 0.7, 7.0, {0.5}},
                                             {4.5, 0.75, 0.0, {0.5}},
                                             {5.0, 0.8, 8.0, {0.5}},
                                             {6.0, 1.0, 10.0, {0.75, 0.5}},
                                             {7.0, 1.0, 11.0, {0.75, 0.5}},
                                             {8.0, 1.25, 13.0, {1.0, 0.75, 0.5}},
                                             {9.0, 1.25, 0.0, {1.0, 0.75}},
                                             {10.0, 1.5, 16.0, {1.25, 1.0, 0.75}},
                                             {11.0, 1.5, 0.0, {1.0, 0.75}},
                                             {12.0, 1.75, 18.0, {1.5, 1.25, 1.0}},
                                             {14.0, 2.0, 21.0, {1.5, 1.25, 1.0}},
                                             {16.0, 2.0, 24.0, {1.5, 1.0}},
                                             {18.0, 2.5, 27.0, {2.0, 1.5, 1.0}},
                                             {20.0, 2.5, 30.0, {2.0, 1.5, 1.0}},
                                             {22.0, 2.5, 34.0, {2.0, 1.5, 1.0}},
                                             {24.0, 3.0, 36.0, {2.0, 1.5, 1.0}},
                                             {27.0, 3.0, 41.0, {2.0, 1.5, 1.0}},
                                             {30.0, 3.5, 46.0, {3.0, 2.0, 1.5, 1.0}},
                                             {33.0, 3.5, 50.0, {3.0, 2.0, 1.5}},
                                             {36.0, 4.0, 55.0, {3.0, 2.0, 1.5}},
                                             {39.0, 4.0, 60.0, {3.0, 2.0, 1.5}},
                                             {42.0, 4.5, 65.0, {4.0, 3.0, 2.0, 1.5}},
                                             {45.0, 4.5, 70.0, {4.0, 3.0, 2.0, 1.5}},
                                             {48.0, 5.0, 75.0, {4.0, 3.0, 2.0, 1.5}},
                                             {52.0, 5.0, 80.0, {4.0, 3.0, 2.0, 1.5}},
                                             {56.0, 5.5, 85.0, {4.0, 3.0, 2.0, 1.5}},
                                             {60.0, 5.5, 90.0, {4.0, 3.0, 2.0, 1.5}},
                                             {64.0, 6.0, 95.0, {4.0, 3.0, 2.0, 1.5}}}};

/// A row of the table of unified threads: inches, and threads per inch; 0: none.
struct UnifiedRow {
  const char* name;
  double diameter;
  double coarse;
  double fine;
  double nut;
};
constexpr std::array<UnifiedRow, 20> kUnified{
    {{"#0", 0.060, 0., 80., 5. / 32},     {"#1", 0.073, 64., 72., 5. / 32},
     {"#2", 0.086, 56., 64., 3. / 16},    {"#3", 0.099, 48., 56., 3. / 16},
     {"#4", 0.112, 40., 48., 1. / 4},     {"#5", 0.125, 40., 44., 5. / 16},
     {"#6", 0.138, 32., 40., 5. / 16},    {"#8", 0.164, 32., 36., 11. / 32},
     {"#10", 0.190, 24., 32., 3. / 8},    {"#12", 0.216, 24., 28., 7. / 16},
     {"1/4", 1. / 4, 20., 28., 7. / 16},  {"5/16", 5. / 16, 18., 24., 1. / 2},
     {"3/8", 3. / 8, 16., 24., 9. / 16},  {"7/16", 7. / 16, 14., 20., 11. / 16},
     {"1/2", 1. / 2, 13., 20., 3. / 4},   {"9/16", 9. / 16, 12., 18., 7. / 8},
     {"5/8", 5. / 8, 11., 18., 15. / 16}, {"3/4", 3. / 4, 10., 16., 9. / 8},
     {"7/8", 7. / 8, 9., 14., 21. / 16},  {"1", 1., 8., 12., 3. / 2}}};

/// A row of the table of tapping threads, millimetres: the number of the size, the diameter, the pitch.
struct TappingRow {
  double size;
  double diameter;
  double pitch;
};
constexpr std::array<TappingRow, 14> kTapping{{{1.5, 1.52, 0.5},
                                               {1.9, 1.90, 0.6},
                                               {2.2, 2.24, 0.8},
                                               {2.6, 2.57, 0.9},
                                               {2.9, 2.90, 1.1},
                                               {3.3, 3.30, 1.3},
                                               {3.5, 3.53, 1.3},
                                               {3.9, 3.91, 1.3},
                                               {4.2, 4.22, 1.4},
                                               {4.8, 4.80, 1.6},
                                               {5.5, 5.46, 1.8},
                                               {6.3, 6.25, 1.8},
                                               {8.0, 8.00, 2.1},
                                               {9.5, 9.65, 2.1}}};

/// A row of the table of pipe threads, millimetres: the name of the size, the outer diameter, the pitch.
struct PipeRow {
  const char* name;
  double diameter;
  double pitch;
};
constexpr std::array<PipeRow, 10> kPipe{{{"G1/16", 7.723, 0.907},
                                         {"G1/8", 9.728, 0.907},
                                         {"G1/4", 13.157, 1.337},
                                         {"G3/8", 16.662, 1.337},
                                         {"G1/2", 20.955, 1.814},
                                         {"G3/4", 26.441, 1.814},
                                         {"G1", 33.249, 2.309},
                                         {"G1 1/4", 41.91, 2.309},
                                         {"G1 1/2", 47.803, 2.309},
                                         {"G2", 59.614, 2.309}}};

/// Trapezoidal threads, millimetres: diameter, pitch.
constexpr std::array<std::pair<double, double>, 14> kTrapezoidal{{{8.0, 1.5},
                                                                  {10.0, 2.0},
                                                                  {12.0, 3.0},
                                                                  {14.0, 3.0},
                                                                  {16.0, 4.0},
                                                                  {18.0, 4.0},
                                                                  {20.0, 4.0},
                                                                  {24.0, 5.0},
                                                                  {28.0, 5.0},
                                                                  {32.0, 6.0},
                                                                  {36.0, 6.0},
                                                                  {40.0, 7.0},
                                                                  {50.0, 8.0},
                                                                  {60.0, 9.0}}};

/// Wood screw threads, millimetres: diameter, pitch.
constexpr std::array<std::pair<double, double>, 16> kWood{{{1.6, 0.8},
                                                           {2.0, 0.9},
                                                           {2.5, 1.1},
                                                           {3.0, 1.35},
                                                           {3.5, 1.6},
                                                           {4.0, 1.8},
                                                           {4.5, 2.0},
                                                           {5.0, 2.2},
                                                           {5.5, 2.4},
                                                           {6.0, 2.6},
                                                           {7.0, 3.2},
                                                           {8.0, 3.6},
                                                           {10.0, 4.5},
                                                           {12.0, 5.0},
                                                           {16.0, 6.0},
                                                           {20.0, 7.0}}};

/// Deviation of a drawn diameter from a nominal one, metres.
constexpr double kOffNominal = 1e-4;

/// True if ISO 261 has the diameter: whole millimetres, multiples of five above 80 mm.
bool isNominal(double diameter) {
  const double step = kMillimetre * (diameter > 80.5 * kMillimetre ? 5.0 : 1.0);
  return std::abs(diameter - step * std::round(diameter / step)) <= kOffNominal;
}

/// A fine pitch of ISO 261 for large diameters, millimetres.
struct FineOfLarge {
  double pitch;
  double least;  ///< diameter
  double most;
};
constexpr std::array<FineOfLarge, 6> kFineOfLarge{{{6.0, 70.0, 600.0},
                                                   {4.0, 42.0, 300.0},
                                                   {3.0, 30.0, 250.0},
                                                   {2.0, 24.0, 150.0},
                                                   {1.5, 24.0, 80.0},
                                                   {1.0, 24.0, 30.0}}};

std::string named(const char* before, double size) {
  std::ostringstream name;
  name.imbue(std::locale::classic());
  name << before << size;
  return name.str();
}

/// A size without fine pitches and nuts. Millimetres.
ThreadSize sizeOf(ThreadFamily family, const std::string& name, double diameter, double pitch) {
  return {family, name, kMillimetre * diameter, kMillimetre * pitch};
}

std::vector<ThreadSize> metricSizes() {
  std::vector<ThreadSize> sizes;
  for (const MetricRow& row : kMetric) {
    ThreadSize& size =
        sizes.emplace_back(sizeOf(ThreadFamily::Metric, named("M", row.diameter), row.diameter, row.coarse));
    size.acrossFlats = kMillimetre * row.nut;
    for (const double pitch : row.fine) {
      if (pitch > 0.0) size.finePitches.push_back(kMillimetre * pitch);
    }
  }
  return sizes;
}

std::vector<ThreadSize> unifiedSizes() {
  const auto pitchOf = [](double threads) { return threads > 0.0 ? kInch / threads : 0.0; };
  std::vector<ThreadSize> sizes;
  for (const UnifiedRow& row : kUnified) {
    sizes.push_back({ThreadFamily::Unified, row.name, kInch * row.diameter, pitchOf(row.coarse), {}, kInch * row.nut});
    if (row.fine > 0.0) sizes.back().finePitches = {pitchOf(row.fine)};
  }
  return sizes;
}

std::vector<ThreadSize> tappingSizes() {
  std::vector<ThreadSize> sizes;
  for (const auto& [size, diameter, pitch] : kTapping) {
    sizes.push_back(sizeOf(ThreadFamily::Tapping, named("ST", size), diameter, pitch));
  }
  return sizes;
}

std::vector<ThreadSize> woodSizes() {
  std::vector<ThreadSize> sizes;
  for (const auto& [diameter, pitch] : kWood) {
    sizes.push_back(sizeOf(ThreadFamily::Wood, named("", diameter), diameter, pitch));
  }
  return sizes;
}

std::vector<ThreadSize> pipeSizes() {
  std::vector<ThreadSize> sizes;
  for (const auto& [name, diameter, pitch] : kPipe) {
    sizes.push_back(sizeOf(ThreadFamily::Pipe, name, diameter, pitch));
  }
  return sizes;
}

std::vector<ThreadSize> trapezoidalSizes() {
  std::vector<ThreadSize> sizes;
  for (const auto& [diameter, pitch] : kTrapezoidal) {
    sizes.push_back(sizeOf(ThreadFamily::Trapezoidal, named("Tr", diameter), diameter, pitch));
  }
  return sizes;
}

/// True if the diameter is the size's own, as precisely as threads are drawn.
bool isOfSize(double diameter, const ThreadSize& size) {
  constexpr double kNominalShare = 0.02;
  return std::abs(diameter - size.diameter) <= kNominalShare * size.diameter;
}

}  // namespace

const std::vector<ThreadSize>& threadSizes(ThreadFamily family) {
  static const std::array<const std::vector<ThreadSize>, 6> kSizes{metricSizes(), unifiedSizes(), tappingSizes(),
                                                                   woodSizes(),   pipeSizes(),    trapezoidalSizes()};
  return kSizes[static_cast<std::size_t>(family)];
}

const ThreadSize& nearestThreadSize(ThreadFamily family, double diameter) {
  const std::vector<ThreadSize>& sizes = threadSizes(family);
  return *std::min_element(sizes.begin(), sizes.end(), [&](const ThreadSize& one, const ThreadSize& other) {
    return std::abs(one.diameter - diameter) < std::abs(other.diameter - diameter);
  });
}

const ThreadSize& usualThreadSize(double diameter) {
  constexpr double kExactly = 0.003;
  const ThreadSize& metric = nearestThreadSize(ThreadFamily::Metric, diameter);
  const ThreadSize& inch = nearestThreadSize(ThreadFamily::Unified, diameter);
  const auto isExactly = [&](const ThreadSize& size) {
    return std::abs(diameter - size.diameter) <= kExactly * size.diameter;
  };
  return inch.pitch > 0.0 && isExactly(inch) && !isExactly(metric) ? inch : metric;
}

std::vector<double> metricPitches(double diameter) {
  constexpr double kNominalShare = 0.04;
  std::vector<double> pitches;
  const ThreadSize& nearest = nearestThreadSize(ThreadFamily::Metric, diameter);
  if (std::abs(diameter - nearest.diameter) <= kNominalShare * nearest.diameter) {
    pitches = nearest.finePitches;
    pitches.push_back(nearest.pitch);
  }
  for (const auto& [pitch, least, most] : kFineOfLarge) {
    const bool isIn = diameter >= kMillimetre * least - kOffNominal && diameter <= kMillimetre * most + kOffNominal;
    if (isIn && isNominal(diameter)) pitches.push_back(kMillimetre * pitch);
  }
  std::sort(pitches.begin(), pitches.end(), std::greater<>());
  pitches.erase(std::unique(pitches.begin(), pitches.end()), pitches.end());
  return pitches;
}

double pitchOfCore(double diameter, double depth) {
  constexpr double kShallowest = 0.48;
  constexpr double kDeepest = 0.65;
  std::vector<double> pitches = metricPitches(diameter);
  const ThreadSize& inch = nearestThreadSize(ThreadFamily::Unified, diameter);
  if (isOfSize(diameter, inch)) {
    pitches.push_back(inch.pitch);
    pitches.insert(pitches.end(), inch.finePitches.begin(), inch.finePitches.end());
  }
  const auto suits = [&](double pitch) { return depth >= kShallowest * pitch && depth <= kDeepest * pitch; };
  const auto found = std::find_if(pitches.begin(), pitches.end(), suits);
  return found == pitches.end() ? 0.0 : *found;
}

bool isCoreByStandard(double pitch, double depth) {
  constexpr double kOfNut = 0.541266;
  constexpr double kOfBolt = 0.613435;
  const auto isDepth = [&](double inPitches) {
    return std::abs(depth - inPitches * pitch) <= 0.01 * inPitches * pitch;
  };
  return isDepth(kOfNut) || isDepth(kOfBolt);
}

bool isCoarsePitch(double diameter, double pitch) {
  const auto isCoarseIn = [&](ThreadFamily family) {
    const ThreadSize& size = nearestThreadSize(family, diameter);
    return isOfSize(diameter, size) && size.pitch == pitch;
  };
  return isCoarseIn(ThreadFamily::Metric) || isCoarseIn(ThreadFamily::Unified);
}

}  // namespace glissade
