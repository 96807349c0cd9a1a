#include "engine/check/scenario_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "engine/base/limits.h"
#include "engine/check/stated_json.h"
#include "engine/geometry/pose_json.h"

namespace glissade::check {
namespace {

/// Limits of a stated pitch, metres a turn. Diameters limit it further (thread_axis.h).
constexpr double kLeastStatedPitch = 1e-5;
constexpr double kMostStatedPitch = 1.0;

Asset readAsset(const JsonCursor& at) {
  Asset asset;
  asset.id = at.at("id").nonEmptyText();
  asset.path = at.at("path").exactText();
  if (const auto hash = at.find("sha256")) asset.sha256 = hash->text();
  if (const auto unit = at.find("unit")) asset.unit = unit->length();
  if (const auto up = at.find("up_axis")) asset.up = up->named(kUpAxisNames);
  if (const auto deflection = at.find("deflection")) asset.deflection = deflection->length();
  if (const auto close = at.find("close_holes")) asset.closeHoles = close->boolean();
  return asset;
}

Geometry readShape(const JsonCursor& at, const std::set<std::string>& assets) {
  if (at.json().size() != 1) at.fail(GLISSADE_TEXT("does not name exactly one shape"));
  const auto asset = [&](const JsonCursor& name) {
    if (assets.count(name.text()) == 0)
      name.fail({GLISSADE_TEXT("names the asset '%1', which is not in /assets"), {name.text()}});
    return name.text();
  };
  if (const auto mesh = at.find("mesh")) {
    if (mesh->json().is_string()) return MeshGeometry{asset(*mesh)};
    return MeshGeometry{asset(mesh->at("asset")), true, mesh->has("part") ? mesh->at("part").nonEmptyText() : ""};
  }
  if (const auto urdf = at.find("urdf")) return UrdfGeometry{asset(*urdf)};
  if (const auto step = at.find("step")) {
    return StepGeometry{asset(step->at("asset")), step->has("part") ? step->at("part").nonEmptyText() : "",
                        step->has("as_one") && step->at("as_one").boolean()};
  }
  if (const auto box = at.find("box")) {
    if (!limits::isSize(readVector(*box).minCoeff()))
      box->fail(GLISSADE_TEXT("has a size that is not above zero, or below 1e-12 m"));
    return BoxGeometry{readVector(*box)};
  }
  if (const auto cylinder = at.find("cylinder")) {
    return CylinderGeometry{cylinder->at("radius").length(), cylinder->at("length").length()};
  }
  return SphereGeometry{at.at("sphere").at("radius").length()};
}

StatedScenario::StatedBody readStatedBody(const JsonCursor& at, const std::set<std::string>& assets) {
  StatedScenario::StatedBody body;
  body.id = BodyId(at.at("id").nonEmptyText());
  body.name = at.has("name") ? at.at("name").text() : body.id.text();
  body.geometry = readShape(at.at("geometry"), assets);
  if (const auto pose = at.find("pose")) body.pose = readPose(*pose);
  return body;
}

/// True if a person says that the body does not leave.
bool saysThatItStays(const JsonCursor& body) {
  const auto attributes = body.find("attributes");
  if (!attributes) return false;
  const auto isTrue = [&](const char* name) {
    const auto value = attributes->find(name);
    return value && value->json().is_boolean() && value->boolean();
  };
  return isTrue("base") || isTrue("stays");
}

PairWord readPair(const JsonCursor& at) {
  at.allowOnly({"a", "b", "kind", "allowance", "accepted", "pitch_m", "turned"});
  PairWord word{BodyId(at.at("a").nonEmptyText()), BodyId(at.at("b").nonEmptyText())};
  if (word.a == word.b) at.at("b").fail(GLISSADE_TEXT("is the same body as 'a'"));
  if (const auto kind = at.find("kind")) {
    constexpr std::array<const char*, 7> kKinds{"planar",  "cylindrical", "thread", "press",
                                                "overlap", "contact",     "clash"};
    word.kind = kind->text();
    if (std::find(kKinds.begin(), kKinds.end(), word.kind) == kKinds.end())
      kind->fail(GLISSADE_TEXT("is not a kind of fit"));
  }
  if (const auto allowance = at.find("allowance")) {
    word.allowance = allowance->coordinate();
    if (*word.allowance < 0.0)
      allowance->fail(GLISSADE_TEXT("is below zero"), GLISSADE_TEXT("Give metres, 0 or more."));
  }
  if (const auto accepted = at.find("accepted")) word.accepted = accepted->boolean();
  if (const auto pitch = at.find("pitch_m")) {
    word.pitch = pitch->number();
    const double size = std::abs(*word.pitch);
    if (!(size >= kLeastStatedPitch && size <= kMostStatedPitch)) {
      pitch->fail(GLISSADE_TEXT("is not a pitch"),
                  GLISSADE_TEXT("Give metres a turn, from 0.00001 to 1; below zero for a left-handed thread."));
    }
  }
  if (const auto turned = at.find("turned")) {
    word.turned = BodyId(turned->text());
    if (word.turned != word.a && word.turned != word.b) turned->fail(GLISSADE_TEXT("is neither of the two bodies"));
  }
  return word;
}

FitWords readFitWords(const JsonCursor& at) {
  FitWords fits;
  const std::string mode = at.at("mode").text();
  if (mode != "on" && mode != "off") at.at("mode").fail(GLISSADE_TEXT("is neither \"on\" nor \"off\""));
  fits.on = mode == "on";
  if (const auto clash = at.find("accept_clashes")) {
    fits.acceptedClash = clash->coordinate();
    if (fits.acceptedClash < 0.0) clash->fail(GLISSADE_TEXT("is below zero"), GLISSADE_TEXT("Give metres, 0 or more."));
  }
  const auto cut = at.find("cut");
  for (std::size_t i = 0; cut && i < cut->sizeUpTo(limits::kMostBodies); ++i) {
    fits.cut.push_back(cut->element(i).nonEmptyText());
  }
  const auto pairs = at.find("pairs");
  for (std::size_t i = 0; pairs && i < pairs->sizeUpTo(limits::kMostBodies); ++i) {
    const PairWord word = readPair(pairs->element(i));
    if (fits.about(word.a, word.b) != nullptr) {
      pairs->element(i).fail(GLISSADE_TEXT("is about a pair that was there before"), GLISSADE_TEXT("Remove one."));
    }
    fits.pairs.push_back(word);
  }
  return fits;
}

std::vector<NodeDescription> readNodes(const JsonCursor& list) {
  std::vector<NodeDescription> nodes;
  for (std::size_t i = 0; i < list.sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor at = list.element(i);
    nodes.push_back({at.at("id").nonEmptyText()});
    if (const auto name = at.find("name")) nodes.back().name = name->text();
    if (const auto occurrence = at.find("occurrence")) nodes.back().occurrence = occurrence->text();
    if (const auto designator = at.find("designator")) nodes.back().designator = designator->text();
    if (const auto in = at.find("in")) nodes.back().in = in->text();
  }
  return nodes;
}

ForbiddenRegion readForbidden(const JsonCursor& at) {
  ForbiddenRegion region;
  region.place = at.at("place").text();
  const JsonCursor boxes = at.at("boxes");
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const JsonCursor box = boxes.element(i);
    if (box.size() != 6) box.fail(GLISSADE_TEXT("is not six numbers"));
    const auto corner = [&](std::size_t first) {
      return Vector3(box.element(first).coordinate(), box.element(first + 1).coordinate(),
                     box.element(first + 2).coordinate());
    };
    region.boxes.emplace_back(corner(0), corner(3));
    if (region.boxes.back().isEmpty()) box.fail(GLISSADE_TEXT("has a minimum above its maximum"));
  }
  return region;
}

bool forbids(const JsonCursor& edit) {
  const auto attributes = edit.find("attributes");
  const auto forbidden = attributes ? attributes->find("forbidden") : std::nullopt;
  return forbidden && forbidden->boolean();
}

void readFormat(const JsonCursor& root) {
  if (root.at("format").text() != "glissade-scenario")
    root.at("format").fail(GLISSADE_TEXT("is not \"glissade-scenario\""));
  if (root.at("version").wholeNumber() != 1)
    root.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
}

}  // namespace

StatedScenario readStatedScenario(const JsonCursor& root) {
  readFormat(root);
  StatedScenario scenario;
  std::set<std::string> assets;
  const auto assetList = root.find("assets");
  for (std::size_t i = 0; assetList && i < assetList->sizeUpTo(limits::kMostBodies); ++i) {
    scenario.assets.push_back(readAsset(assetList->element(i)));
    assets.insert(scenario.assets.back().id);
  }
  std::set<BodyId> ids;
  const auto addId = [&](const BodyId& id, const JsonCursor& at) {
    if (id.text().find('/') != std::string::npos)
      at.at("id").fail(GLISSADE_TEXT("holds a '/'"), GLISSADE_TEXT("Leave it out."));
    if (!ids.insert(id).second) at.at("id").fail({GLISSADE_TEXT("has the id '%1' a second time"), {id.text()}});
  };
  std::vector<std::string> staying;
  const auto addBodies = [&](const JsonCursor& list, std::vector<StatedScenario::StatedBody>& bodies) {
    for (std::size_t i = 0; i < list.sizeUpTo(limits::kMostBodies); ++i) {
      bodies.push_back(readStatedBody(list.element(i), assets));
      addId(bodies.back().id, list.element(i));
      if (saysThatItStays(list.element(i))) staying.push_back(bodies.back().id.text());
    }
  };
  addBodies(root.at("bodies"), scenario.bodies);
  const JsonCursor object = root.at("object");
  scenario.object.push_back(readStatedBody(object, assets));
  addId(scenario.object.front().id, object);
  if (saysThatItStays(object)) staying.push_back(scenario.object.front().id.text());
  if (const auto with = object.find("with")) addBodies(*with, scenario.object);
  if (const auto leftOut = root.find("left_out")) addBodies(*leftOut, scenario.leftOut);
  if (const auto product = root.find("product")) scenario.nodes = readNodes(*product);
  if (const auto centre = object.find("centre_on_vertex_mean")) scenario.centreOnVertexMean = centre->boolean();
  if (const auto point = object.find("reference_point")) scenario.referencePoint = readVector(*point);
  scenario.start = readPose(root.at("start"));
  const JsonCursor goal = root.at("goal");
  if (!goal.isString()) scenario.goal = readPose(goal);
  if (goal.isString() && goal.text() != "out") goal.fail(GLISSADE_TEXT("is neither a configuration nor \"out\""));
  const JsonCursor workspace = root.at("workspace");
  scenario.workspace = Box3(readVector(workspace.at("min")), readVector(workspace.at("max")));
  if (const auto parameters = root.find("parameters")) {
    for (const auto& item : parameters->json().items()) {
      const auto id = parameterByKey(item.key());
      if (!id) parameters->at(item.key()).fail(GLISSADE_TEXT("is not a parameter"));
      scenario.parameters[*id] = parameters->at(item.key()).number();
    }
  }
  if (const auto fits = root.find("fits")) scenario.fits = readFitWords(*fits);
  if (const auto joints = root.find("joints")) {
    scenario.fits.snaps = readSnaps(*joints);
    scenario.fits.partings = readPartings(*joints, {});
    scenario.joints = readJointWords(*joints, {});
  }
  if (const auto demands = root.find("sequence")) {
    scenario.demands = readDemands(*demands);
    if (const auto joints = demands->find("joints")) {
      scenario.joints = readJointWords(*joints, std::move(scenario.joints));
    }
    scenario.fits.partings = readPartingsOfSequence(*demands, std::move(scenario.fits.partings));
  }
  scenario.demands.stay.insert(scenario.demands.stay.end(), staying.begin(), staying.end());
  const auto forbidden = root.find("forbidden_regions");
  for (std::size_t i = 0; forbidden && i < forbidden->sizeUpTo(limits::kMostBodies); ++i) {
    scenario.forbidden.push_back(readForbidden(forbidden->element(i)));
  }
  const auto places = root.find("places");
  for (std::size_t i = 0; places && i < places->sizeUpTo(limits::kMostBodies); ++i) {
    scenario.forbidsPlaces = scenario.forbidsPlaces || forbids(places->element(i));
  }
  return scenario;
}

}  // namespace glissade::check
