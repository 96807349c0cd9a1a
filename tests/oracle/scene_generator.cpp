#include "tests/oracle/scene_generator.h"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/shapes.h"

namespace glissade::oracle {
namespace {

using Json = nlohmann::json;

/// Random numbers that are equal with every standard library.
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t index) : engine_(seed * 1'000'003U + index) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  std::size_t below(std::size_t n) { return engine_() % n; }
  bool flip() { return below(2) == 1; }
  Point point(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
  Rotation rotation() {
    for (;;) {
      const Rotation q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      if (norm > 0.1 && norm < 1.0) return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
    }
  }

 private:
  std::mt19937_64 engine_;
};

struct Body {
  Triangles triangles;
  Placement X;
};

/// A scene in units of its size.
struct Draft {
  std::string kind;
  std::vector<Body> bodies;
  Triangles object;
  Placement start;
  Placement goal;
  double reach = 2.0;  ///< half the workspace's edge
};

Triangles someObject(Dice& dice) {
  switch (dice.below(4)) {
    case 0: return box(dice.uniform(0.1, 0.6), dice.uniform(0.1, 0.6), dice.uniform(0.02, 0.6));
    case 1: return moved(lShape(0.6, dice.uniform(0.05, 0.3), dice.uniform(0.05, 0.3)), {-0.15, -0.15, 0.0});
    case 2: return extruded(regularPolygon(3 + static_cast<int>(dice.below(10)), 0.25), dice.uniform(0.1, 0.8));
    default: return hollowBox(0.5, 0.4);
  }
}

Draft clutter(Dice& dice) {
  Draft draft{"clutter", {}, someObject(dice), {{-1.8, 0, 0}, dice.rotation()}, {{1.8, 0, 0}, dice.rotation()}, 2.0};
  for (std::size_t i = 0; i < 5; ++i) {
    draft.bodies.push_back({box(dice.uniform(0.01, 1.0), dice.uniform(0.1, 1.0), dice.uniform(0.1, 1.0)),
                            {dice.point(1.1), dice.rotation()}});
  }
  return draft;
}

/// A window with a small clearance, in a wall that may be as thin as a foil.
Draft window(Dice& dice) {
  const double thickness = std::pow(10.0, dice.uniform(-6.0, -1.0));
  const double width = dice.uniform(0.2, 0.6);
  const double depth = dice.uniform(0.2, 0.6);
  const double gap = std::pow(10.0, dice.uniform(-4.0, -1.0));
  const Outline opening = rectangle(width + 2 * gap, depth + 2 * gap);
  return {"window",
          {{extrudedRing(rectangle(3, 3), opening, thickness), {}}},
          box(width, depth, dice.uniform(0.05, 0.5)),
          {{0, 0, -1}, {0, 0, 0, 1}},
          {{0, 0, 1}, {0, 0, 0, 1}},
          2.0};
}

/// A pin in a round hole, both with the same number of corners.
Draft hole(Dice& dice) {
  const int corners = 4 * (3 + static_cast<int>(dice.below(8)));
  const double radius = dice.uniform(0.05, 0.3);
  const double gap = std::pow(10.0, dice.uniform(-4.0, -2.0));
  return {"hole",
          {{extrudedRing(squareOf(corners, 2.0), regularPolygon(corners, radius + gap), 0.5), {}}},
          extruded(regularPolygon(corners, radius), 1.0),
          {{0, 0, -1.2}, {0, 0, 0, 1}},
          {{0, 0, 0.1}, {0, 0, 0, 1}},
          2.0};
}

/// Blocks with common planes. The object is a small gap above a block, with its sides in the planes of the block's
/// sides.
Draft coplanar(Dice& dice) {
  const double gap = std::pow(10.0, dice.uniform(-4.0, -2.0));
  return {"coplanar",
          {{box(2, 2, 0.5), {{0, 0, -0.25}, {0, 0, 0, 1}}},
           {box(0.5, 2, 0.5), {{-1.25, 0, -0.25}, {0, 0, 0, 1}}},
           {box(0.5, 0.5, 0.5), {{0.25, 0.25, -0.75}, {0, 0, 0, 1}}},
           {box(0.5, 0.5, 0.5), {{0.75, 0.75, 0.25}, {0, 0, 0, 1}}}},
          box(0.5, 0.5, 0.5),
          {{-0.75, 0.75, 0.25 + gap}, {0, 0, 0, 1}},
          {{0.25 - 2 * gap, 0.25, 0.25 + gap}, {0, 0, 0, 1}},
          2.0};
}

/// The object and another solid are in the cavity of a solid.
Draft hollow(Dice& dice) {
  Draft draft{"hollow",
              {{hollowBox(2.0 + std::pow(10.0, dice.uniform(-5.0, 0.0)), 2.0), {}},
               {box(0.2, 0.2, 0.2), {{0, 0, 0.1}, dice.rotation()}}},
              someObject(dice),
              {{-0.45, -0.4, -0.4}, dice.rotation()},
              {{0.45, 0.4, -0.4}, dice.rotation()},
              1.5};
  if (dice.flip()) {  // the object is a box around the other solid
    draft.object = hollowBox(1.0, 0.8);
    draft.start = draft.goal = {{0.0, 0.0, 0.1}, {0, 0, 0, 1}};
    draft.goal.position = {0.1, 0.05, 0.12};
  }
  return draft;
}

/// Turns by exactly half a circle, about an axis of the frame or any other.
Draft halfTurn(Dice& dice) {
  Draft draft = dice.flip() ? hollow(dice) : clutter(dice);
  draft.kind = "half turn";
  if (dice.flip()) {
    const std::array<Rotation, 3> turns{Rotation{1, 0, 0, 0}, Rotation{0, 1, 0, 0}, Rotation{0, 0, 1, 0}};
    draft.start.orientation = {0, 0, 0, 1};
    draft.goal.orientation = turns[dice.below(3)];
  } else {
    const auto [x, y, z, w] = draft.start.orientation;
    draft.goal.orientation = {w, z, -y, -x};  // multiplied by (1, 0, 0, 0)
  }
  return draft;
}

Draft draftOf(Dice& dice) {
  switch (dice.below(6)) {
    case 0: return clutter(dice);
    case 1: return window(dice);
    case 2: return hole(dice);
    case 3: return coplanar(dice);
    case 4: return hollow(dice);
    default: return halfTurn(dice);
  }
}

/// Chooses the size and place of the scene and the units of its files, and writes it.
class SceneWriter {
 public:
  SceneWriter(std::string folder, Dice& dice)
      : folder_(std::move(folder)),
        dice_(dice),
        size_(std::pow(10.0, dice.uniform(-6.0, 6.0))),
        unit_(dice.flip() ? 1.0 : 0.001) {
    if (dice.below(4) == 0) origin_ = size_ * dice.point(std::pow(10.0, dice.uniform(0.0, 4.0)));
  }

  std::string write(const Draft& draft) {
    json_ = {{"format", "glissade-scenario"}, {"version", 1}, {"name", draft.kind}, {"assets", Json::array()}};
    json_["object"] = {
        {"id", "object"}, {"name", "object"}, {"geometry", {{"mesh", addAsset(draft.object, "object")}}}};
    json_["bodies"] = Json::array();
    for (const Body& body : draft.bodies) addBody(body);
    json_["start"] = poseJson(draft.start);
    json_["goal"] = poseJson(draft.goal);
    const double half = draft.reach * size_;
    json_["workspace"] = {{"min", origin_ - Point{half, half, half}}, {"max", origin_ + Point{half, half, half}}};
    save("scenario.json", json_.dump(1) + "\n");
    std::ostringstream words;
    words << draft.kind << ", " << size_ << " m";
    return words.str();
  }

 private:
  void addBody(const Body& body) {
    const std::string id = "body" + std::to_string(json_["bodies"].size());
    json_["bodies"].push_back({{"id", id},
                               {"name", id},
                               {"mobility", "static"},
                               {"geometry", {{"mesh", addAsset(body.triangles, id)}}},
                               {"pose", poseJson(body.X)}});
  }

  std::string addAsset(const Triangles& triangles, const std::string& id) {
    Triangles inFile = triangles;
    for (Triangle& triangle : inFile) {
      for (Point& p : triangle) p = (size_ / unit_) * p;
    }
    const auto format = static_cast<MeshFormat>(dice_.below(4));
    save(id + endingOf(format), meshFile(inFile, format));
    json_["assets"].push_back({{"id", id}, {"path", id + endingOf(format)}, {"unit", unit_}, {"up_axis", "z"}});
    return id;
  }

  Json poseJson(const Placement& X) const {
    return {{"position", size_ * X.position + origin_}, {"orientation", X.orientation}};
  }

  void save(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << content;
  }

  std::string folder_;
  Dice& dice_;
  double size_;
  double unit_;
  Point origin_{0.0, 0.0, 0.0};
  Json json_;
};

}  // namespace

std::string writeScene(const std::string& folder, std::uint64_t seed, std::uint64_t index) {
  Dice dice(seed, index);
  const Draft draft = draftOf(dice);
  return SceneWriter(folder, dice).write(draft);
}

}  // namespace glissade::oracle
