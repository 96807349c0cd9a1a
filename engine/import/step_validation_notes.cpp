#include "engine/import/step_validation_notes.h"

#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <cmath>
#include <optional>
#include <sstream>

#include "engine/import/import_protocol.h"
#include "engine/import/step_deflection.h"

namespace glissade {
namespace {

/// Relative deviation of a stated figure that rounding in the file and the integration of another system explain.
constexpr double kStatedShare = 1e-4;

/// Sums over all solids of a product, in its frame.
struct ProductMeasures {
  double volume = 0.0;
  double area = 0.0;
  double uncertainty = 0.0;  ///< uncertainty of the volume
  double size = 0.0;
  gp_XYZ moment;  ///< moment of the volume about the product's origin
  std::size_t solids = 0;
  std::string path;  ///< path of the last solid
};

void add(const ValidatedSolid& solid, const gp_Trsf& placement, ProductMeasures& product) {
  const TriangleMeasures& own = solid.measures;
  gp_XYZ origin = own.origin;
  placement.Transforms(origin);
  const gp_XYZ moment = gp_Vec(own.moment).Transformed(placement).XYZ();
  product.volume += own.volume;
  product.area += own.area;
  product.uncertainty += own.uncertainty();
  product.moment += origin * own.volume + moment;
  product.size = std::max(product.size, origin.Modulus() + own.size);
  product.path = solid.path;
  ++product.solids;
}

std::optional<ProductMeasures> measuresOf(const TopoDS_Shape& shape,
                                          const std::function<const ValidatedSolid*(const TopoDS_Shape&)>& solidOf) {
  const TopoDS_Shape product = shape.Located(TopLoc_Location());
  if (TopExp_Explorer(product, TopAbs_FACE, TopAbs_SOLID).More()) return std::nullopt;
  ProductMeasures measures;
  for (TopExp_Explorer at(product, TopAbs_SOLID); at.More(); at.Next()) {
    const ValidatedSolid* solid = solidOf(at.Current().Located(TopLoc_Location()));
    if (solid == nullptr) return std::nullopt;
    add(*solid, at.Current().Location().Transformation(), measures);
  }
  return measures.solids > 0 ? std::optional(measures) : std::nullopt;
}

std::string inDigits(double value) {
  constexpr int kDigits = 7;
  std::ostringstream text;
  text.precision(kDigits);
  text << value;
  return text.str();
}

class Comparison {
 public:
  Comparison(const StatedMeasures& stated, const ProductMeasures& own) : stated_(stated), own_(own) {
    const bool isPart = own.solids == 1 && !own.path.empty();
    where_ = isPart ? Message(GLISSADE_TEXT("part '%1'"), {own.path})
                    : Message(GLISSADE_TEXT("validation property %1"), {stated.entity});
  }

  void compare(StepNotes& notes) const {
    if (stated_.volume && !(std::abs(own_.volume - *stated_.volume) <= uncertainty())) {
      notes.push_back(note({GLISSADE_TEXT("its triangles enclose %1 cubic millimetres, and the file states %2: they "
                                          "differ by more than the deviation of the triangles explains"),
                            {inDigits(own_.volume), inDigits(*stated_.volume)}}));
    }
    if (stated_.area && !(std::abs(own_.area - *stated_.area) <= areaUncertainty())) {
      notes.push_back(note({GLISSADE_TEXT("its triangles have %1 square millimetres, and the file states %2: they "
                                          "differ by more than the deviation of the triangles explains"),
                            {inDigits(own_.area), inDigits(*stated_.area)}}));
    }
    if (stated_.centroid && own_.volume != 0.0) compareCentroid(notes);
  }

 private:
  double uncertainty() const { return own_.uncertainty + kStatedShare * std::abs(*stated_.volume); }

  /// A chord is shorter than its arc by a share of angle^2 / 24. The uncertainty covers both directions, and twice that
  /// for faces that need larger angles.
  double areaUncertainty() const { return (kStepAngle * kStepAngle / 6.0 + kStatedShare) * *stated_.area; }

  void compareCentroid(StepNotes& notes) const {
    const gp_XYZ centroid = own_.moment / own_.volume;
    const double apart = (centroid - stated_.centroid->XYZ()).Modulus();
    const double explained = (own_.uncertainty / std::abs(own_.volume) + kStatedShare) * own_.size;
    if (apart <= explained) return;
    notes.push_back(note({GLISSADE_TEXT("the centroid of its triangles is %1 mm from the one that the file states: "
                                        "more than the deviation of the triangles explains"),
                          {inDigits(apart)}}));
  }

  StepNote note(const Message& what) const { return {import_protocol::kVolumeLine, where_, what}; }

  const StatedMeasures& stated_;
  const ProductMeasures& own_;
  Location where_;
};

}  // namespace

StepNotes validationNotes(const std::vector<StatedMeasures>& stated,
                          const std::function<const ValidatedSolid*(const TopoDS_Shape&)>& solidOf) {
  StepNotes notes;
  for (const StatedMeasures& each : stated) {
    const auto own = measuresOf(each.shape, solidOf);
    if (own) Comparison(each, *own).compare(notes);
  }
  return notes;
}

}  // namespace glissade
