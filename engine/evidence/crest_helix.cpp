#include "engine/evidence/crest_helix.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace glissade::evidence {
namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;
/// Radians: vertices that are around an axis leave no wider gap.
constexpr double kWidestGap = 0.28 * kWholeTurn;
/// The crests of a helix leave this share of a turn free of crests at least; a flat crest takes an eighth.
constexpr double kLeastFree = 0.5;
/// The pitch may be off by this share of it.
constexpr double kPitchOff = 0.03;
/// Least pitch of a thread, in diameters of the wall.
constexpr double kLeastPitch = 0.04;
/// Length of the mean of the crests' phases, as unit vectors, from which a pitch suits them.
constexpr double kLeastLength = 0.6;

double phaseOf(const Around& crest, const CrestHelix& helix) {
  return helix.starts * crest.angle - kWholeTurn * crest.height / helix.pitch();
}

struct Mean {
  double height = 0.0;
  double phase = 0.0;  ///< radians
};

Mean meanOf(const Around* first, const Around* last, const CrestHelix& helix) {
  double height = 0.0;
  std::complex<double> sum = 0.0;
  for (const Around* each = first; each != last; ++each) {
    height += each->height;
    sum += std::polar(1.0, phaseOf(*each, helix));
  }
  return {height / static_cast<double>(last - first), std::arg(sum)};
}

/// The turn of the phase from the lower half of the crests to the upper one, radians a metre.
double driftOf(const std::vector<Around>& crests, const CrestHelix& helix) {
  const Around* middle = crests.data() + crests.size() / 2;
  const Mean lower = meanOf(crests.data(), middle, helix);
  const Mean upper = meanOf(middle, crests.data() + crests.size(), helix);
  return std::remainder(upper.phase - lower.phase, kWholeTurn) / (upper.height - lower.height);
}

/// The crests are so many that no pitch suits them by chance, and no half of a turn is without one.
bool isUnbroken(const std::vector<Around>& crests, double pitch) {
  constexpr std::size_t kFewest = 24;
  constexpr double kLongestGap = 0.5;
  for (std::size_t i = 1; i < crests.size(); ++i) {
    if (crests[i].height - crests[i - 1].height > kLongestGap * std::abs(pitch)) return false;
  }
  return crests.size() >= kFewest;
}

/// The pitches that suit crests: the spectrum of their directions over their heights, for a number of starts.
class PitchSpectrum {
 public:
  PitchSpectrum(const std::vector<Around>& crests, double diameter, int starts)
      : width_(kLeastPitch * diameter / kInLeastPitch), starts_(starts) {
    const double low = crests.front().height;
    sums_.resize(static_cast<std::size_t>((crests.back().height - low) / width_) + 1);
    for (const Around& crest : crests) {
      sums_[static_cast<std::size_t>((crest.height - low) / width_)] += std::polar(1.0, starts * crest.angle);
    }
    for (std::complex<double>& sum : sums_) {
      sum /= static_cast<double>(crests.size());
      most_ += std::abs(sum);
    }
    leastTurns_ = width_ * starts / (kMostLead * diameter);
  }

  /// The largest of the pitches that put the crests at one side of the axis best.
  std::optional<CrestHelix> best() {
    constexpr double kBetter = 1.01;
    if (most_ < kLeastLength) return std::nullopt;
    std::size_t size = 1;
    while (size < kTrialsInTurn * sums_.size()) size *= 2;
    sums_.resize(size);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double>().fwd(spectrum, sums_);
    const auto count = static_cast<double>(size);
    double longest = kLeastLength;
    std::optional<CrestHelix> found;
    for (auto i = static_cast<std::size_t>(leastTurns_ * count) + 1; i <= size / kInLeastPitch; ++i) {
      for (const bool isLeft : {false, true}) {
        const double length = std::abs(spectrum[isLeft ? size - i : i]);
        if (length <= kBetter * longest) continue;
        longest = length;
        found = {(isLeft ? -1.0 : 1.0) * starts_ * width_ * count / static_cast<double>(i), starts_};
      }
    }
    return found;
  }

 private:
  /// Crests at heights that no pitch tells apart are one sum: a sixteenth of the least pitch. Crests that are around
  /// the axis at one height therefore cancel.
  static constexpr std::size_t kInLeastPitch = 16;
  /// From one pitch to the next, a crest turns by less than an eighth of a turn.
  static constexpr std::size_t kTrialsInTurn = 8;

  double width_;  ///< of a sum, metres
  int starts_;
  std::vector<std::complex<double>> sums_;  ///< of the directions of crests, for each step of height
  double most_ = 0.0;                       ///< no pitch suits better
  double leastTurns_ = 0.0;                 ///< of the largest lead, in a step of height
};

std::optional<CrestHelix> helixWith(int starts, const std::vector<Around>& crests, double diameter) {
  auto helix = PitchSpectrum(crests, diameter, starts).best();
  if (!helix) return std::nullopt;
  helix->lead = kWholeTurn * starts / (kWholeTurn / helix->pitch() + driftOf(crests, *helix));
  return areHelix(crests, *helix) && isUnbroken(crests, helix->pitch()) ? helix : std::nullopt;
}

}  // namespace

double widestGap(std::vector<double> angles) {
  if (angles.empty()) return kWholeTurn;
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + kWholeTurn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest;
}

std::vector<Around> aroundOf(const TriangleMesh& mesh, const Vector3& point, const Vector3& axis) {
  const Vector3 u = axis.unitOrthogonal();
  const Vector3 v = axis.cross(u);
  std::vector<Around> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const Vector3& vertex : mesh.vertices) {
    const Vector3 arm = vertex - point;
    const double x = arm.dot(u);
    const double y = arm.dot(v);
    vertices.push_back({std::hypot(x, y), arm.dot(axis), std::atan2(y, x)});
  }
  return vertices;
}

bool areAround(const std::vector<Around>& vertices) {
  std::vector<double> angles;
  for (const Around& vertex : vertices) angles.push_back(vertex.angle);
  return widestGap(std::move(angles)) <= kWidestGap;
}

bool areHelix(const std::vector<Around>& crests, const CrestHelix& helix) {
  std::vector<double> phases;
  for (const Around& crest : crests) phases.push_back(std::remainder(phaseOf(crest, helix), kWholeTurn));
  if (widestGap(std::move(phases)) < kLeastFree * kWholeTurn) return false;
  const double pitch = std::abs(helix.pitch());
  if (crests.back().height - crests.front().height < pitch) return false;
  return std::abs(driftOf(crests, helix)) / kWholeTurn * pitch <= kPitchOff;
}

std::optional<CrestHelix> helixOfLead(const std::vector<Around>& crests, double lead) {
  for (int starts = 1; starts <= kMostStarts; ++starts) {
    if (areHelix(crests, {lead, starts})) return CrestHelix{lead, starts};
  }
  return std::nullopt;
}

std::optional<CrestHelix> helixOf(const std::vector<Around>& crests, double diameter) {
  if (crests.empty() || !isUnbroken(crests, kMostLead * diameter)) return std::nullopt;
  for (int starts = 1; starts <= kMostStarts; ++starts) {
    if (const auto helix = helixWith(starts, crests, diameter)) return helix;
  }
  return std::nullopt;
}

}  // namespace glissade::evidence
