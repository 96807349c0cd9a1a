#include "engine/evidence/named_screw.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <regex>
#include <sstream>
#include <vector>

#include "engine/evidence/crest_helix.h"
#include "engine/evidence/pulled_thread.h"
#include "engine/evidence/turn.h"

namespace glissade::evidence {
namespace {

/// Limits of the ratio of a screw's cylinder to the diameter in its name: a drawn core, and rounding of a mesh.
constexpr double kThinnest = 0.75;
constexpr double kThickest = 1.06;
/// Largest radius of a hole for the screw, in radii of the screw.
constexpr double kHoleReach = 2.0;
/// Relative excess by which a point of the shaft may be outside of its cylinder.
constexpr double kBeyond = 2e-3;
/// Distance of the axes of a shaft and of the walls between ribs, in radii of the shaft.
constexpr double kSameAxisShare = 0.1;
/// Largest angle about the axis without a wall, radians: a shaft leaves a slot of half a turn sideways.
constexpr double kWidestSlot = 0.95 * std::numbers::pi;
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

/// True if the last word is one for a screw: "black screw (2)", and not "screw cap".
bool endsWithScrew(const std::string& name) {
  return hasWord(name, "(screw|bolt|schraube|(^|[^A-Za-z])vis)[^A-Za-z]*$");
}

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

/// The round walls of the host about a shaft: none, only those between the ribs of a slot, which are as wide as the
/// shaft or wider, or those of a hole for the shaft or beside its axis.
enum class WallsAbout { None, OfSlot, OfHole };

WallsAbout wallsAbout(const RoundFace& shaft, const PlacedBody& host) {
  WallsAbout walls = WallsAbout::None;
  for (const RoundFace& hole : host.rounds) {
    if (hole.isShaft || hole.radius > kHoleReach * shaft.radius) continue;
    const double from = (hole.point - shaft.point).dot(shaft.axis);
    const double beside = (hole.point - shaft.point - from * shaft.axis).norm();
    const double half = 0.5 * (hole.high - hole.low);
    const double middle = from + 0.5 * (hole.low + hole.high) * hole.axis.dot(shaft.axis);
    const bool isAbout = beside < hole.radius || beside + hole.radius <= shaft.radius;
    const bool isBetweenRibs = beside < kSameAxisShare * shaft.radius && hole.radius >= shaft.radius;
    if (!isAbout || middle + half <= shaft.low || middle - half >= shaft.high) continue;
    walls = std::max(walls, isBetweenRibs ? WallsAbout::OfSlot : WallsAbout::OfHole);
  }
  return walls;
}

/// The screw's part in the host.
struct PartOfScrew {
  double low = std::numeric_limits<double>::infinity();  ///< range along the axis
  double high = -low;
  std::vector<double> angles{};  ///< angles about the axis at which the host is, radians

  /// True if the host is around the screw, so that the screw does not leave sideways.
  bool isHeld() const { return widestGap(angles) < kWidestSlot; }
};

/// True if the host is no deeper in the shaft than the deepest thread.
bool isShallow(const PlacedBody& host, const RoundFace& shaft, const PartOfScrew& part) {
  return std::all_of(host.tree.triangles().begin(), host.tree.triangles().end(), [&](const Triangle& wall) {
    const TurnedTriangle passed = turned(wall[0], wall[1], wall[2], shaft.point, shaft.axis);
    return passed.high < part.low || passed.low > part.high ||
           passed.nearest >= (1.0 - kMostThreadDepth) * shaft.radius;
  });
}

/// Finds the screw's part in the host, if that part is within the cylinder.
class PartInHost {
 public:
  PartInHost(const RoundFace& shaft, const PlacedBody& host) : shaft_(shaft), host_(host) {}

  std::optional<PartOfScrew> of(const PlacedBody& screw, const TriangleMesh& hollow) {
    for (const Vector3& vertex : host_.mesh.vertices) {
      if (isBeyond(vertex) && screw.contains(vertex)) return std::nullopt;
    }
    PartOfScrew part;
    const Vector3 u = shaft_.axis.unitOrthogonal();
    const Vector3 v = shaft_.axis.cross(u);
    for (const auto& [a, b, c] : hollow.triangles) {
      const Triangle piece{hollow.vertices[a], hollow.vertices[b], hollow.vertices[c]};
      if (!isInside((piece[0] + piece[1] + piece[2]) / 3.0)) continue;  // it belongs to the host's surface
      for (const Vector3& p : piece) {
        if (isBeyond(p)) return std::nullopt;
        const Vector3 from = p - shaft_.point;
        part.low = std::min(part.low, from.dot(shaft_.axis));
        part.high = std::max(part.high, from.dot(shaft_.axis));
        part.angles.push_back(std::atan2(from.dot(v), from.dot(u)));
      }
    }
    return part.low < part.high ? std::optional(std::move(part)) : std::nullopt;
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
  const std::string name = screw.body.name.substr(0, kLongestName);
  const auto size = screwSizeIn(name);
  if (!size && (!endsWithScrew(name) || isNoScrewName(name))) return std::nullopt;
  const PlacedBody& guest = bodies.at(screw);
  const PlacedBody& solid = bodies.at(host);
  for (const RoundFace& shaft : guest.rounds) {
    const double share = size ? 2.0 * shaft.radius / *size : 1.0;
    if (!shaft.isShaft || share < kThinnest || share > kThickest) continue;
    const WallsAbout walls = wallsAbout(shaft, solid);
    if (walls == WallsAbout::OfHole) continue;
    const MeshPtr hollow = bodies.hollowOf(host, screw, stop);
    if (!hollow) return std::nullopt;
    const auto part = PartInHost(shaft, solid).of(guest, transformed(*hollow, host.X_WB));
    const bool mayBeDeep = size && walls == WallsAbout::None;
    if (!part || !part->isHeld() || (!mayBeDeep && !isShallow(solid, shaft, *part))) continue;
    return ScrewInSolid{shaft.point, shaft.axis, shaft.radius, part->low, part->high};
  }
  return std::nullopt;
}

}  // namespace glissade::evidence
