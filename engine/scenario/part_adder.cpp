#include "engine/scenario/part_adder.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/base/file.h"
#include "engine/base/printable_text.h"
#include "engine/import/asset_path.h"
#include "engine/import/step_import.h"
#include "engine/scenario/scenario_bodies.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

std::string stemOf(const PartFile& part) { return printableLine(fs::path(part.path).stem().string()); }

/// What a body of the part is called, and known by: a '/' has its meaning in ids.
std::string nameOf(const PartFile& part) { return part.part.empty() ? stemOf(part) : part.part; }
std::string idOf(const PartFile& part) {
  std::string id = nameOf(part);
  std::replace(id.begin(), id.end(), '/', '.');
  return id;
}

std::string uniqueId(const std::string& stem, const std::set<std::string>& taken) {
  std::string id = stem;
  for (int number = 2; taken.count(id) > 0; ++number) id = stem + "-" + std::to_string(number);
  return id;
}

std::set<std::string> assetIds(const Scenario& scenario) {
  std::set<std::string> ids;
  for (const Asset& asset : scenario.assets) ids.insert(asset.id);
  return ids;
}

std::set<std::string> bodyIds(const Scenario& scenario) {
  std::set<std::string> ids;
  for (const BodyDescription* body : allBodiesOf(scenario)) ids.insert(body->id);
  return ids;
}

}  // namespace

PartAdder::PartAdder(Scenario& scenario, const std::string& file)
    : scenario_(scenario), folder_(folderOf(file)), saved_(!file.empty()) {}

BodyDescription PartAdder::bodyOf(const PartFile& part) {
  BodyDescription body;
  body.id = uniqueId(idOf(part), bodyIds(scenario_));
  body.name = part.part.empty() ? body.id : part.part;
  body.mobility = part.role == PartRole::Mobile ? Mobility::Mobile : Mobility::Static;
  body.geometry = geometryOf(part);
  return body;
}

void PartAdder::addBody(const PartFile& part) { scenario_.bodies.push_back(bodyOf(part)); }

void PartAdder::addToObject(const PartFile& part) {
  std::vector<BodyDescription>& bodies = scenario_.object.bodies;
  if (hasObject_) {
    bodies.push_back(bodyOf(part));
    return;
  }
  hasObject_ = true;
  bodies.assign(1, {idOf(part), nameOf(part), Mobility::Static, geometryOf(part)});
}

Geometry PartAdder::geometryOf(const PartFile& part) {
  if (isStepFile(part.path)) return StepGeometry{assetOf(part), part.part};
  if (isUrdfFile(part.path)) return UrdfGeometry{assetOf(part)};
  return MeshGeometry{assetOf(part)};
}

std::string PartAdder::assetOf(const PartFile& part) {
  const auto same = std::find_if(scenario_.assets.begin(), scenario_.assets.end(), [&](const Asset& asset) {
    std::error_code noneThere;
    return asset.unit == part.unit && asset.up == part.up && asset.deflection == part.deflection &&
           asset.closeHoles == part.closeHoles && fs::equivalent(assetFile(asset, folder_), part.path, noneThere);
  });
  if (same != scenario_.assets.end()) return same->id;
  const std::string path = fs::absolute(part.path).lexically_normal().generic_string();
  const std::string id = uniqueId(stemOf(part), assetIds(scenario_));
  scenario_.assets.push_back(
      {id, saved_ ? assetPathFrom(folder_, path) : path, "", part.unit, part.up, part.deflection, part.closeHoles});
  return id;
}

}  // namespace glissade
