#include "engine/documents/parts_list.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "engine/documents/plan_words.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/model/designation.h"
#include "engine/sequence/plan_bodies.h"

namespace glissade {
namespace {

using TextsById = std::map<BodyId, std::string>;

/// The designations of fasteners, from the joints of their motions.
TextsById designationsIn(const AssemblyPlan& plan) {
  TextsById designations;
  for (const StepMotion* motion : allMotionsOf(plan)) {
    for (const StepJoint& joint : motion->joints) {
      if (!joint.designation.empty()) designations[joint.body] = joint.designation;
    }
  }
  return designations;
}

/// Properties that two meshes of one part have in common, independent of their poses: counts, and area and volume up to
/// rounding.
class Shape {
 public:
  explicit Shape(const TriangleMesh& mesh)
      : vertices_(mesh.vertices.size()),
        triangles_(mesh.triangles.size()),
        area_(areaOf(mesh)),
        volume_(signedVolume(mesh)) {}
  bool operator==(const Shape& other) const {
    constexpr double kRounding = 1e-6;  // tolerance as a share of each value
    const double length = std::sqrt(area_);
    return vertices_ == other.vertices_ && triangles_ == other.triangles_ &&
           std::abs(area_ - other.area_) <= kRounding * area_ &&
           std::abs(volume_ - other.volume_) <= kRounding * length * length * length;
  }

 private:
  std::size_t vertices_;
  std::size_t triangles_;
  double area_;
  double volume_;
};

/// Numbers shapes: meshes of one shape have the same number.
class Shapes {
 public:
  std::size_t numberOf(const MeshPtr& mesh) {
    const auto known = numbers_.find(mesh);
    if (known != numbers_.end()) return known->second;
    const Shape shape(*mesh);
    const auto same = std::find(shapes_.begin(), shapes_.end(), shape);
    const auto number = static_cast<std::size_t>(same - shapes_.begin());
    if (same == shapes_.end()) shapes_.push_back(shape);
    numbers_.emplace(mesh, number);
    return number;
  }

 private:
  std::vector<Shape> shapes_;
  std::map<MeshPtr, std::size_t> numbers_;
};

/// The name without a counter at its end: "nut" of "nut-2". Parts of one shape have it in common.
std::string stemOf(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789");
  if (digits == std::string::npos || digits + 1 == name.size()) return name;
  const std::size_t end = name.find_last_not_of("-_ .:", digits);
  return end == std::string::npos || end == digits ? name : name.substr(0, end + 1);
}

/// Numbers of steps in the order of assembly, by body.
std::map<BodyId, std::size_t> stepsByBody(const AssemblyPlan& plan) {
  std::map<BodyId, std::size_t> steps;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    for (const BodyId& id : plan.steps[i].bodies()) steps[id] = plan.steps.size() - i;
  }
  return steps;
}

/// The first step that brings a part of the row; the base is there before, and parts without a step come last.
std::size_t firstUseOf(const PartsListRow& row) {
  constexpr std::size_t kNever = static_cast<std::size_t>(-1);
  if (row.hasBase) return 0;
  return row.steps.empty() ? kNever : row.steps.front();
}

}  // namespace

bool namesOnePart(const std::string& designation) {
  const auto said = designationIn(designation);
  if (!said) return !designation.empty();
  const bool hasLength =
      said->part == StandardPart::Screw || said->part == StandardPart::SetScrew || said->part == StandardPart::Pin;
  return !hasLength || said->length > 0.0;
}

std::vector<PartsListRow> partsList(const AssemblyPlan& plan, const AssembledProduct& product) {
  const TextsById designations = designationsIn(plan);
  const std::map<BodyId, std::size_t> stepOf = stepsByBody(plan);
  const std::set<BodyId> base(plan.staying.begin(), plan.staying.end());
  std::vector<PartsListRow> rows;
  Shapes shapes;
  constexpr std::size_t kAnyShape = static_cast<std::size_t>(-1);  // shape of all fasteners of one designation
  std::map<std::tuple<std::string, std::size_t, std::string>, std::size_t> known;
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    const RigidBody& body = product.bodies[i];
    const auto said = designations.find(body.id);
    const std::string designation = said == designations.end() ? std::string() : said->second;
    const std::string name = kindOfPart(i, product);
    const bool isDesignated = namesOnePart(designation);
    const auto [at, isNew] =
        known.emplace(std::tuple(designation, isDesignated ? kAnyShape : shapes.numberOf(body.mesh),
                                 isDesignated ? std::string() : stemOf(name)),
                      rows.size());
    if (isNew) rows.push_back({name, {}, designation});
    PartsListRow& row = rows[at->second];
    if (row.name != name && !isDesignated) row.name = stemOf(name);
    ++row.count;
    row.bodies.push_back(body.id);
    const auto step = stepOf.find(body.id);
    if (base.count(body.id) != 0) {
      row.hasBase = true;
    } else if (step == stepOf.end()) {
      ++row.withoutStep;
    } else {
      row.steps.push_back(step->second);
    }
  }
  for (PartsListRow& row : rows) {
    std::sort(row.steps.begin(), row.steps.end());
    row.steps.erase(std::unique(row.steps.begin(), row.steps.end()), row.steps.end());
  }
  std::stable_sort(rows.begin(), rows.end(), [](const PartsListRow& a, const PartsListRow& b) {
    return std::tuple(firstUseOf(a), a.name) < std::tuple(firstUseOf(b), b.name);
  });
  return rows;
}

std::string stepsText(const PartsListRow& row, const DocumentWords& words) {
  std::string steps = row.hasBase ? words(GLISSADE_TEXT("base")) : std::string();
  const auto add = [&](const std::string& text) { steps += (steps.empty() ? "" : ", ") + text; };
  for (std::size_t i = 0; i < row.steps.size();) {
    std::size_t end = i + 1;
    while (end < row.steps.size() && row.steps[end] == row.steps[end - 1] + 1) ++end;
    const std::string first = std::to_string(row.steps[i]);
    const bool isRange = end - i > 2;
    add(isRange ? first + "–" + std::to_string(row.steps[end - 1]) : first);
    i = isRange ? end : i + 1;
  }
  if (row.withoutStep > 0) add(words(GLISSADE_TEXT("no step")));
  return steps;
}

}  // namespace glissade
