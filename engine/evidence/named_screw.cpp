#include "engine/evidence/named_screw.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <regex>
#include <sstream>

namespace glissade::evidence {
namespace {

/// Limits of the ratio of a screw's cylinder to the diameter in its name: a drawn core, and rounding of a mesh.
constexpr double kThinnest = 0.75;
constexpr double kThickest = 1.06;
/// Largest radius of a hole for the screw, in radii of the screw.
constexpr double kHoleReach = 2.0;
/// Relative excess by which a point of the shaft may be outside of its cylinder.
constexpr double kBeyond = 2e-3;
constexpr double kOnScrew = 1e-8;  ///< metres: nearer points are on the surface
constexpr std::size_t kLongestName = 200;
constexpr double kMillimetre = 1e-3;
constexpr double kInch = 25.4e-3;

double numberIn(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return value;
}

bool hasWord(const std::string& name, const char* words) {
  const std::regex pattern("(" + std::string(words) + ")", std::regex::icase);
  return std::regex_search(name, pattern);
}

bool isScrewName(const std::string& name) { return hasWord(name, "screw|bolt|schraube|vis |shcs|bhcs|fhcs"); }

/// True for names of other parts that have sizes of threads.
bool isNoScrewName(const std::string& name) {
  return hasWord(name, "nut|washer|insert|bearing|spacer|standoff|mutter|scheibe|rondelle|ecrou");
}

/// "M4x10", "M 4 x 10", and "M4" for a part whose words say that it is a screw.
std::optional<double> metric(const std::string& name, bool isScrew) {
  static const std::regex pattern(R"((?:^|[^A-Za-z0-9])M ?(\d{1,2}(?:[.,]\d{1,2})?)(\s*[xX*]\s*\d)?)");
  for (std::sregex_iterator each(name.begin(), name.end(), pattern), end; each != end; ++each) {
    if (isScrew || (*each)[2].matched) return kMillimetre * numberIn((*each)[1]);
  }
  return std::nullopt;
}

/// "ST4.2x35", and "4x30" for a part whose words say that it is a screw.
std::optional<double> cutting(const std::string& name, bool isScrew) {
  static const std::regex pattern(R"((?:^|[^A-Za-z0-9.,])(ST ?)?(\d{1,2}(?:[.,]\d{1,2})?)(\s*[xX*]\s*\d)?)");
  for (std::sregex_iterator each(name.begin(), name.end(), pattern), end; each != end; ++each) {
    const bool isSize = (*each)[1].matched || (isScrew && (*each)[3].matched);
    if (isSize) return kMillimetre * numberIn((*each)[2]);
  }
  return std::nullopt;
}

/// "#10-32", "1/4-20" or "1_4-20".
std::optional<double> unified(const std::string& name) {
  static const std::regex pattern(R"re((?:#(\d{1,2})|(?:^|[^0-9/_])(\d{1,2})[/_](\d{1,2})"?) ?-(\d{1,2}))re");
  std::smatch match;
  if (!std::regex_search(name, match, pattern)) return std::nullopt;
  if (match[1].matched) return kInch * (0.060 + 0.013 * numberIn(match[1]));
  return kInch * numberIn(match[2]) / std::max(1.0, numberIn(match[3]));
}

/// True if the host has a hole about the axis at the shaft.
bool hasHole(const PlacedBody& host, const RoundFace& shaft) {
  return std::any_of(host.rounds.begin(), host.rounds.end(), [&](const RoundFace& hole) {
    if (hole.isShaft || hole.radius > kHoleReach * shaft.radius) return false;
    const double from = (hole.point - shaft.point).dot(shaft.axis);
    const double beside = (hole.point - shaft.point - from * shaft.axis).norm();
    const double half = 0.5 * (hole.high - hole.low);
    const double middle = from + 0.5 * (hole.low + hole.high) * hole.axis.dot(shaft.axis);
    return beside < shaft.radius && middle + half > shaft.low && middle - half < shaft.high;
  });
}

/// The range along the axis of the screw's part in the host, if that part is within the cylinder.
class PartInHost {
 public:
  PartInHost(const RoundFace& shaft, const PlacedBody& host) : shaft_(shaft), host_(host) {}

  std::optional<std::pair<double, double>> of(const PlacedBody& screw, const TriangleMesh& hollow) {
    for (const Vector3& vertex : host_.mesh.vertices) {
      if (isBeyond(vertex) && screw.contains(vertex)) return std::nullopt;
    }
    for (const auto& [a, b, c] : hollow.triangles) {
      const Triangle piece{hollow.vertices[a], hollow.vertices[b], hollow.vertices[c]};
      if (!isInside((piece[0] + piece[1] + piece[2]) / 3.0)) continue;  // it belongs to the host's surface
      for (const Vector3& p : piece) {
        if (isBeyond(p)) return std::nullopt;
        const double along = (p - shaft_.point).dot(shaft_.axis);
        low_ = std::min(low_, along);
        high_ = std::max(high_, along);
      }
    }
    return low_ < high_ ? std::optional(std::pair(low_, high_)) : std::nullopt;
  }

 private:
  bool isInside(const Vector3& p) const {
    return host_.tree.nearest(p, kOnScrew).distance >= kOnScrew && host_.contains(p);
  }
  bool isBeyond(const Vector3& p) const {
    return (p - shaft_.point).cross(shaft_.axis).norm() > (1.0 + kBeyond) * shaft_.radius;
  }

  const RoundFace& shaft_;
  const PlacedBody& host_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -low_;
};

}  // namespace

std::optional<double> screwSizeIn(const std::string& text) {
  const std::string name = text.substr(0, kLongestName);
  if (isNoScrewName(name)) return std::nullopt;
  const bool isScrew = isScrewName(name);
  if (const auto size = metric(name, isScrew)) return size;
  if (const auto size = unified(name)) return size;
  return cutting(name, isScrew);
}

std::optional<ScrewInSolid> screwInSolid(const Placement& screw, const Placement& host, PlacedBodies& bodies,
                                         const StopToken& stop) {
  const auto size = screwSizeIn(screw.body.name);
  if (!size) return std::nullopt;
  const PlacedBody& guest = bodies.at(screw);
  const PlacedBody& solid = bodies.at(host);
  for (const RoundFace& shaft : guest.rounds) {
    const double share = 2.0 * shaft.radius / *size;
    if (!shaft.isShaft || share < kThinnest || share > kThickest || hasHole(solid, shaft)) continue;
    const MeshPtr hollow = bodies.hollowOf(host, screw, stop);
    if (!hollow) return std::nullopt;
    const auto part = PartInHost(shaft, solid).of(guest, transformed(*hollow, host.X_WB));
    if (!part) continue;
    return ScrewInSolid{shaft.point, shaft.axis, shaft.radius, part->first, part->second};
  }
  return std::nullopt;
}

}  // namespace glissade::evidence
