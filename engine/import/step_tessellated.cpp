#include "engine/import/step_tessellated.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <gp_Ax3.hxx>
#include <map>
#include <optional>
#include <unordered_map>

#include "engine/base/printable_text.h"
#include "engine/import/import_refusal.h"
#include "engine/import/step_shape_kinds.h"

namespace glissade {
namespace {

using HeldPoint = std::array<double, 3>;
using HeldTriangle = std::array<std::uint32_t, 3>;

/// All numbers of a list of lists.
template <class Number>
std::vector<Number> numbersOf(std::string_view text) {
  std::vector<Number> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '+' || c == '(' || c == ')' || c == ',' || static_cast<unsigned char>(c) <= ' ') {
      ++at;
      continue;
    }
    Number number{};
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    if (error != std::errc()) throw ImportRefusal{GLISSADE_TEXT("a list of its numbers holds something else")};
    numbers.push_back(number);
    at = static_cast<std::size_t>(end - text.data());
  }
  return numbers;
}

/// Collects the triangles of an item from its entities.
class TessellationReader {
 public:
  explicit TessellationReader(const StepEntities& entities) : entities_(entities) {}

  StepTessellation read(std::uint64_t item) {
    StepTessellation result;
    try {
      add(item, 0);
      if (triangles_.empty()) throw ImportRefusal{GLISSADE_TEXT("it has no triangle with three corners")};
    } catch (const ImportRefusal& why) {
      result.fault = why.reason;
      return result;
    }
    orient();
    for (const HeldPoint& point : points_) result.vertices.insert(result.vertices.end(), point.begin(), point.end());
    for (const HeldTriangle& corners : triangles_) {
      result.indices.insert(result.indices.end(), corners.begin(), corners.end());
    }
    return result;
  }

 private:
  static constexpr int kDeepest = 16;

  void add(std::uint64_t item, int depth) {
    const std::vector<StepRecord> records = entities_.recordsOf(item);
    const std::vector<std::string_view> values = valuesOfKind(records);
    const std::size_t before = points_.size();
    const std::string kind = stepKindOf(records);
    if (depth > kDeepest) throw ImportRefusal{GLISSADE_TEXT("its items are nested too deeply")};
    if (kind == "TESSELLATED_SOLID" || kind == "TESSELLATED_SHELL" || kind == "TESSELLATED_GEOMETRIC_SET") {
      if (values.size() < 2) throw ImportRefusal{{GLISSADE_TEXT("%1 has too few values"), {shown(item, kind)}}};
      for (const std::uint64_t child : stepReferencesIn(values[1])) addChild(child, depth);
    } else if (kind == "TRIANGULATED_FACE" || kind == "COMPLEX_TRIANGULATED_FACE") {
      addTriangulation(shown(item, kind), values, 5);
    } else if (kind == "TRIANGULATED_SURFACE_SET" || kind == "COMPLEX_TRIANGULATED_SURFACE_SET") {
      addTriangulation(shown(item, kind), values, 4);
    } else {
      throw ImportRefusal{{GLISSADE_TEXT("its item %1 is of a kind that is not read"), {shown(item, kind)}}};
    }
    reposition(records, before);
  }

  /// Adds a child; edges and vertices of a tessellation are no surface.
  void addChild(std::uint64_t child, int depth) {
    const std::vector<StepRecord> records = entities_.recordsOf(child);
    if (stepShapeRole(entities_, records) != StepShapeRole::NoMaterial) add(child, depth + 1);
  }

  static std::string shown(std::uint64_t id, const std::string& kind) {
    return printableLine(kind) + " #" + std::to_string(id);
  }

  /// The values with the name first, as in an entity of one type; values of a supertype come before those of its
  /// subtypes.
  static std::vector<std::string_view> valuesOfKind(const std::vector<StepRecord>& records) {
    std::vector<std::string_view> values;
    if (records.size() == 1) return stepValues(records.front().arguments);
    for (const std::string_view name : {std::string_view("REPRESENTATION_ITEM"), std::string_view("TESSELLATED_FACE"),
                                        std::string_view("TESSELLATED_SURFACE_SET")}) {
      for (const StepRecord& record : records) {
        if (record.type == name) append(stepValues(record.arguments), values);
      }
    }
    for (const StepRecord& record : records) {
      const bool isSuper = record.type == "REPRESENTATION_ITEM" || record.type == "TESSELLATED_FACE" ||
                           record.type == "TESSELLATED_SURFACE_SET" || record.type == "REPOSITIONED_TESSELLATED_ITEM";
      if (!isSuper) append(stepValues(record.arguments), values);
    }
    return values;
  }

  static void append(const std::vector<std::string_view>& more, std::vector<std::string_view>& values) {
    values.insert(values.end(), more.begin(), more.end());
  }

  /// `first`: position of the list of indices among the values. Strips and fans follow in place of triangles.
  void addTriangulation(const std::string& who, const std::vector<std::string_view>& values, std::size_t first) {
    const bool strips = who.rfind("COMPLEX_", 0) == 0;
    if (values.size() < first + (strips ? 3 : 2)) throw ImportRefusal{{GLISSADE_TEXT("%1 has too few values"), {who}}};
    coordinates_ = &coordinatesOf(stepReference(values[1]), who);
    indices_ = numbersOf<std::uint32_t>(values[first]);
    corner_.clear();
    if (!strips) {
      const auto corners = numbersOf<std::uint32_t>(values[first + 1]);
      if (corners.size() % 3 != 0) {
        throw ImportRefusal{{GLISSADE_TEXT("%1 has a triangle without three corners"), {who}}};
      }
      for (std::size_t i = 0; i < corners.size(); i += 3) addTriangle(who, corners[i], corners[i + 1], corners[i + 2]);
      return;
    }
    for (const std::string_view strip : stepList(values[first + 1])) {
      const auto corners = numbersOf<std::uint32_t>(strip);
      for (std::size_t i = 2; i < corners.size(); ++i) {
        const std::size_t odd = i % 2;
        addTriangle(who, corners[i - 2 + odd], corners[i - 1 - odd], corners[i]);
      }
    }
    for (const std::string_view fan : stepList(values[first + 2])) {
      const auto corners = numbersOf<std::uint32_t>(fan);
      for (std::size_t i = 2; i < corners.size(); ++i) addTriangle(who, corners[0], corners[i - 1], corners[i]);
    }
  }

  const std::vector<HeldPoint>& coordinatesOf(std::uint64_t id, const std::string& who) {
    const auto [known, isNew] = lists_.try_emplace(id);
    if (!isNew) return known->second;
    const std::vector<StepRecord> records = entities_.recordsOf(id);
    if (stepKindOf(records) != "COORDINATES_LIST") {
      throw ImportRefusal{{GLISSADE_TEXT("%1 has no COORDINATES_LIST"), {who}}};
    }
    const std::vector<std::string_view> values = valuesOfKind(records);
    const auto numbers = numbersOf<double>(values.empty() ? std::string_view() : values.back());
    if (numbers.size() % 3 != 0) {
      throw ImportRefusal{{GLISSADE_TEXT("a point of COORDINATES_LIST #%1 has no three numbers"), {id}}};
    }
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      known->second.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    }
    return known->second;
  }

  void addTriangle(const std::string& who, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const HeldTriangle corners{cornerOf(who, a), cornerOf(who, b), cornerOf(who, c)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
    triangles_.push_back(corners);
  }

  std::uint32_t cornerOf(const std::string& who, std::uint32_t index) {
    const auto [known, isNew] = corner_.try_emplace(index);
    if (!isNew) return known->second;
    std::size_t number = index;
    if (!indices_.empty()) number = index >= 1 && index <= indices_.size() ? indices_[index - 1] : 0;
    if (number < 1 || number > coordinates_->size()) {
      throw ImportRefusal{{GLISSADE_TEXT("%1 refers to point %2, which is not in its lists"), {who, index}}};
    }
    const HeldPoint& point = (*coordinates_)[number - 1];
    if (!std::all_of(point.begin(), point.end(), [](double value) { return std::isfinite(value); })) {
      throw ImportRefusal{{GLISSADE_TEXT("%1 has a point that is not in space"), {who}}};
    }
    const auto [at, isNewPoint] = indexOf_.try_emplace(point, static_cast<std::uint32_t>(points_.size()));
    if (isNewPoint) points_.push_back(point);
    known->second = at->second;
    return known->second;
  }

  /// Transforms the points that were added from `before` on, which are in another frame.
  void reposition(const std::vector<StepRecord>& records, std::size_t before) {
    for (const StepRecord& record : records) {
      if (record.type != "REPOSITIONED_TESSELLATED_ITEM") continue;
      const auto values = stepValues(record.arguments);
      const auto frame = values.empty() ? std::nullopt : frameOf(stepReference(values.back()));
      if (!frame || before != 0) {
        throw ImportRefusal{GLISSADE_TEXT("it is repositioned in a way that is not read")};
      }
      indexOf_.clear();
      for (std::size_t i = before; i < points_.size(); ++i) {
        gp_XYZ moved = frame->Location().XYZ();
        moved += points_[i][0] * frame->XDirection().XYZ();
        moved += points_[i][1] * frame->YDirection().XYZ();
        moved += points_[i][2] * frame->Direction().XYZ();
        points_[i] = {moved.X(), moved.Y(), moved.Z()};
      }
    }
  }

  std::optional<gp_Ax3> frameOf(std::uint64_t placement) const {
    const std::vector<StepRecord> records = entities_.recordsOf(placement);
    if (stepKindOf(records) != "AXIS2_PLACEMENT_3D") return std::nullopt;
    const auto values = stepValues(records.front().arguments);
    if (values.size() < 4) return std::nullopt;
    const auto location = triple(values[1], HeldPoint{0, 0, 0});
    const auto z = triple(values[2], HeldPoint{0, 0, 1});
    const auto x = triple(values[3], HeldPoint{1, 0, 0});
    const gp_Vec zAxis(z[0], z[1], z[2]);
    const gp_Vec xAxis(x[0], x[1], x[2]);
    constexpr double kLeast = 1e-9;
    if (zAxis.Crossed(xAxis).Magnitude() < kLeast) return std::nullopt;
    return gp_Ax3(gp_Pnt(location[0], location[1], location[2]), gp_Dir(zAxis), gp_Dir(xAxis));
  }

  HeldPoint triple(std::string_view reference, const HeldPoint& otherwise) const {
    const std::vector<StepRecord> records = entities_.recordsOf(stepReference(reference));
    if (records.size() != 1) return otherwise;
    const auto values = stepValues(records.front().arguments);
    const auto numbers = values.size() < 2 ? std::vector<double>() : numbersOf<double>(values[1]);
    return numbers.size() == 3 ? HeldPoint{numbers[0], numbers[1], numbers[2]} : otherwise;
  }

  using HeldSide = std::pair<std::uint32_t, std::uint32_t>;
  struct Use {
    std::size_t triangle;
    bool forward;  ///< from the smaller corner to the larger one
  };

  /// Orients the triangles: neighbours have opposite directions at a common side, and closed surfaces enclose a
  /// positive volume. Strips are written in both senses. Surfaces that are consistent keep their sense relative to each
  /// other, as that of a void.
  void orient() {
    std::map<HeldSide, std::vector<Use>> sides;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = triangles_[t][i];
        const std::uint32_t b = triangles_[t][(i + 1) % 3];
        sides[{std::min(a, b), std::max(a, b)}].push_back({t, a < b});
      }
    }
    const bool agree = std::all_of(sides.begin(), sides.end(), [](const auto& side) {
      return side.second.size() != 2 || side.second[0].forward != side.second[1].forward;
    });
    std::vector<std::vector<std::size_t>> surfaces;
    if (agree) {
      surfaces.emplace_back();
      for (std::size_t t = 0; t < triangles_.size(); ++t) surfaces.back().push_back(t);
    } else {
      surfaces = turnedAlike(sides);
    }
    for (const std::vector<std::size_t>& surface : surfaces) {
      if (volumeOf(surface) >= 0.0) continue;
      for (const std::size_t t : surface) std::swap(triangles_[t][1], triangles_[t][2]);
    }
  }

  /// The connected surfaces, each with its triangles oriented like its first one.
  std::vector<std::vector<std::size_t>> turnedAlike(const std::map<HeldSide, std::vector<Use>>& sides) {
    enum class Seen : std::uint8_t { No, Kept, Turned };
    std::vector<Seen> seen(triangles_.size(), Seen::No);
    const std::vector<HeldTriangle> asRead = triangles_;
    std::vector<std::vector<std::size_t>> surfaces;
    for (std::size_t first = 0; first < triangles_.size(); ++first) {
      if (seen[first] != Seen::No) continue;
      seen[first] = Seen::Kept;
      surfaces.push_back({first});
      for (std::size_t next = 0; next < surfaces.back().size(); ++next) {
        const std::size_t t = surfaces.back()[next];
        for (int i = 0; i < 3; ++i) {
          const std::uint32_t a = asRead[t][i];
          const std::uint32_t b = asRead[t][(i + 1) % 3];
          const std::vector<Use>& uses = sides.at({std::min(a, b), std::max(a, b)});
          if (uses.size() != 2) continue;
          const Use& other = uses[0].triangle == t ? uses[1] : uses[0];
          if (seen[other.triangle] != Seen::No) continue;
          const bool alike = uses[0].forward != uses[1].forward;
          seen[other.triangle] = alike == (seen[t] == Seen::Kept) ? Seen::Kept : Seen::Turned;
          if (seen[other.triangle] == Seen::Turned)
            std::swap(triangles_[other.triangle][1], triangles_[other.triangle][2]);
          surfaces.back().push_back(other.triangle);
        }
      }
    }
    return surfaces;
  }

  /// Six times the volume, about the first point.
  double volumeOf(const std::vector<std::size_t>& surface) const {
    double volume = 0.0;
    for (const std::size_t t : surface) {
      std::array<HeldPoint, 3> p{};
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) p[i][k] = points_[triangles_[t][i]][k] - points_.front()[k];
      }
      volume += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    return volume;
  }

  const StepEntities& entities_;
  std::map<std::uint64_t, std::vector<HeldPoint>> lists_;  ///< by the number of their COORDINATES_LIST
  std::vector<HeldPoint> points_;
  std::map<HeldPoint, std::uint32_t> indexOf_;
  std::vector<HeldTriangle> triangles_;
  // Data of the triangulation that is being added:
  const std::vector<HeldPoint>* coordinates_ = nullptr;
  std::vector<std::uint32_t> indices_;  ///< indices into its coordinates; empty: corners are indices
  std::unordered_map<std::uint32_t, std::uint32_t> corner_;  ///< points by the numbers of the corners
};

}  // namespace

StepTessellation tessellationOf(const StepEntities& entities, std::uint64_t item) {
  return TessellationReader(entities).read(item);
}

}  // namespace glissade
