#include "engine/fits/nut_on_shaft.h"

#include <algorithm>
#include <cmath>

#include "engine/evidence/nut_size.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// Limits of the ratio of a nut's hole to the radius of its shaft. A narrower hole overlaps by more than a thread, a
/// wider one is far from the shaft.
constexpr double kLeastHole = 0.7;
constexpr double kWidestHole = 1.35;
/// A hole counts as wide as its shaft up to this ratio.
constexpr double kEqualHole = 1.02;
/// Width of a regular prism across its flats; 0: it is none.
double widthOf(const TurnedShape& nut) {
  if (nut.sides == 6) return nut.drive.size;
  double width = 0.0;
  for (const AxialSlab& slab : nut.slabs) {
    if (const auto across = acrossFlats(slab.farthest, nut.sides)) width = std::max(width, *across);
  }
  return width;
}

std::vector<ThreadSize> nutSizes(const TurnedShape& nut) {
  if (nut.kind != TurnedKind::Nut || nut.sides == 0) return {};
  return evidence::nutSizes({nut.sides, widthOf(nut), nut.length(), nut.hole});
}

/// A prism with a hole and the name "bolt" also counts: some files exchange these names, and the joint is doubtful.
bool isNamedNut(const Designations& said, std::size_t body) {
  return says(said, body, {StandardPart::Nut}) ||
         (says(said, body, {StandardPart::Screw}) && said[body]->text == "bolt");
}

double saidDiameter(const Designations& said, std::size_t body, StandardPart part) {
  return says(said, body, {part}) ? said[body]->diameter : 0.0;
}

}  // namespace

bool isNut(const ProductShapes& shapes, const Designations& said, std::size_t body) {
  const TurnedShape* shape = shapes.turned(body);
  return shape != nullptr && shape->kind == TurnedKind::Nut && (isNamedNut(said, body) || !nutSizes(*shape).empty());
}

NutOnShaft nutOnShaft(const ProductShapes& shapes, const Designations& said, const NutAndShaft& pair) {
  const auto [nut, shaft, radius, isScrew] = pair;
  if (!isNut(shapes, said, nut)) return {};
  const TurnedShape& shape = *shapes.turned(nut);
  const double share = shape.hole / radius;
  if (share < kLeastHole || share > kWidestHole) return {};
  const bool isNamed = isNamedNut(said, nut);
  const std::vector<ThreadSize> ofNut = evidence::sizesOf(saidDiameter(said, nut, StandardPart::Nut), nutSizes(shape));
  const std::vector<ThreadSize> ofShaft =
      evidence::sizesOf(saidDiameter(said, shaft, StandardPart::Screw), evidence::shaftSizes(radius));
  const bool areKnown = !ofNut.empty() && !ofShaft.empty();
  const bool isTight = isThreadDepth(radius, radius - shape.hole);
  const bool isEqual = !isTight && share <= kEqualHole;
  NutOnShaft found{true, {}, {}, isTight};
  if (areKnown && !evidence::haveOneSize(ofNut, ofShaft)) {
    if (!isTight && !isNamed && !(isScrew && shape.sides == 6)) return {};
    found.doubt = {GLISSADE_TEXT("the sizes do not agree: a shaft of %1 in a nut %2"),
                   {Length{2.0 * radius}, ofNut.front().name}};
  } else if (!isTight && !isEqual && !areKnown) {
    return {};
  }
  // A square with a hole as wide as a plain rod may be any plate.
  if (!isTight && !isNamed && !isScrew && shape.sides != 6) return {};
  if (says(said, shaft, {StandardPart::Pin})) {
    found.doubt = {GLISSADE_TEXT("the name says '%1'"), {said[shaft]->text}};
  }
  if (isTight) {
    found.evidence = GLISSADE_TEXT("the shaft is thicker than the hole");
  } else if (isNamed) {
    found.evidence = GLISSADE_TEXT("the name says that it is a nut");
  } else {
    found.evidence = {GLISSADE_TEXT("it has the width of a nut %1"), {ofNut.front().name}};
  }
  return found;
}

}  // namespace glissade
