#include "engine/scenario/forbidden_regions_json.h"

#include "engine/base/limits.h"

namespace glissade {
namespace {

/// More cells than this are in no topological layer.
constexpr std::size_t kMostBoxes = 4'000'000;

Box3 readBox(const JsonCursor& at) {
  if (at.size() != 6) at.fail("is not a box", "Give six coordinates: the least x, y and z, then the largest.");
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min()[axis] = at.element(static_cast<std::size_t>(axis)).coordinate();
    box.max()[axis] = at.element(static_cast<std::size_t>(axis) + 3).coordinate();
  }
  if (box.isEmpty()) at.fail("is not a box", "Give six coordinates: the least x, y and z, then the largest.");
  return box;
}

}  // namespace

void readForbiddenRegions(const JsonCursor& root, Scenario& scenario) {
  const auto regions = root.find("forbidden_regions");
  for (std::size_t i = 0; regions && i < regions->sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor region = regions->element(i);
    region.allowOnly({"place", "boxes"});
    ForbiddenPlace place{region.at("place").nonEmptyText(), {}};
    const JsonCursor boxes = region.at("boxes");
    for (std::size_t box = 0; box < boxes.sizeUpTo(kMostBoxes); ++box)
      place.boxes.push_back(readBox(boxes.element(box)));
    scenario.forbiddenRegions.push_back(std::move(place));
  }
}

void addForbiddenRegions(const ForbiddenPlaces& places, JsonCursor::Json& json) {
  if (places.empty()) return;
  auto& regions = json["forbidden_regions"] = JsonCursor::Json::array();
  for (const ForbiddenPlace& place : places) {
    auto boxes = JsonCursor::Json::array();
    for (const Box3& box : place.boxes) {
      const Vector3& least = box.min();
      const Vector3& most = box.max();
      boxes.push_back({least.x(), least.y(), least.z(), most.x(), most.y(), most.z()});
    }
    regions.push_back({{"place", place.name}, {"boxes", std::move(boxes)}});
  }
}

}  // namespace glissade
