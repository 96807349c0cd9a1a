#pragma once

#include <algorithm>
#include <vector>

#include "engine/base/random_stream.h"
#include "samples/made-problems/made_problem.h"

namespace glissade::made {

inline constexpr double kRoom = 4.0;  ///< length and width
inline constexpr double kCeiling = 2.5;
inline constexpr double kDoorHigh = 2.05;

inline TriangleMesh table(double length, double width, double height) {
  constexpr double kTop = 0.04;
  constexpr double kLeg = 0.07;
  TriangleMesh mesh = boxBetween({-length / 2, -width / 2, height - kTop}, {length / 2, width / 2, height});
  for (const double x : {-length / 2, length / 2 - kLeg}) {
    for (const double y : {-width / 2, width / 2 - kLeg}) {
      append(mesh, boxBetween({x, y, 0.0}, {x + kLeg, y + kLeg, height - kTop}));
    }
  }
  return mesh;
}

inline TriangleMesh chair() {
  TriangleMesh mesh = table(0.42, 0.42, 0.45);
  append(mesh, boxBetween({-0.21, 0.17, 0.45}, {0.21, 0.21, 0.9}));
  return mesh;
}

/// A corner sofa: two seats with backs, at a right angle.
inline TriangleMesh cornerSofa() {
  TriangleMesh mesh = boxBetween({-1.0, -0.7, 0.05}, {1.0, 0.05, 0.4});
  append(mesh, boxBetween({-1.0, 0.05, 0.05}, {1.0, 0.2, 0.8}));
  append(mesh, boxBetween({0.4, -1.3, 0.05}, {1.0, -0.7, 0.4}));
  append(mesh, boxBetween({0.85, -1.3, 0.4}, {1.0, 0.05, 0.8}));
  return mesh;
}

/// Rooms in a row along x, with a wall and a door between neighbours. Doors are `wide`, at random places.
struct Flat {
  TriangleMesh walls;
  std::vector<double> doors;  ///< y of the middle of each door
};

inline Flat flatOf(int rooms, double wide, RandomStream& stream) {
  constexpr double kHalfWall = 0.06;
  Flat flat;
  const double end = rooms * kRoom;
  append(flat.walls, boxBetween({0, 0, -0.2}, {end, kRoom, 0}));
  append(flat.walls, boxBetween({0, 0, kCeiling}, {end, kRoom, kCeiling + 0.2}));
  append(flat.walls, boxBetween({-0.2, -0.2, -0.2}, {0, kRoom + 0.2, kCeiling + 0.2}));
  append(flat.walls, boxBetween({end, -0.2, -0.2}, {end + 0.2, kRoom + 0.2, kCeiling + 0.2}));
  append(flat.walls, boxBetween({0, -0.2, -0.2}, {end, 0, kCeiling + 0.2}));
  append(flat.walls, boxBetween({0, kRoom, -0.2}, {end, kRoom + 0.2, kCeiling + 0.2}));
  for (int i = 1; i < rooms; ++i) {
    const double x = i * kRoom;
    const double y = stream.uniform(1.0, kRoom - 1.0);
    flat.doors.push_back(y);
    append(flat.walls, boxBetween({x - kHalfWall, 0, 0}, {x + kHalfWall, y - wide / 2, kCeiling}));
    append(flat.walls, boxBetween({x - kHalfWall, y + wide / 2, 0}, {x + kHalfWall, kRoom, kCeiling}));
    append(flat.walls, boxBetween({x - kHalfWall, y - wide / 2, kDoorHigh}, {x + kHalfWall, y + wide / 2, kCeiling}));
  }
  return flat;
}

/// A piece of furniture of some kind and size.
inline TriangleMesh anyFurniture(RandomStream& stream) {
  const double kind = stream.uniform();
  const double a = stream.uniform();
  const double b = stream.uniform();
  if (kind < 0.35) return chair();
  if (kind < 0.6) return table(0.8 + 0.6 * a, 0.6 + 0.3 * b, 0.74);
  if (kind < 0.8) return boxBetween({-0.2, -0.4 - 0.3 * a, 0}, {0.2, 0.4 + 0.3 * a, 0.8 + 1.2 * b});
  return transformed(makeCylinder(0.2 + 0.15 * a, 0.5 + b, 16), Pose::translation({0, 0, 0.25 + 0.5 * b}));
}

/// Adds furniture that meets neither the boxes in `kept` nor other furniture.
inline void furnish(int rooms, int perRoom, std::vector<Box3> kept, RandomStream& stream, TriangleMesh& target) {
  for (int room = 0; room < rooms; ++room) {
    for (int placed = 0, tried = 0; placed < perRoom && tried < 200; ++tried) {
      const TriangleMesh piece = anyFurniture(stream);
      const double x = stream.uniform(room * kRoom + 0.2, (room + 1) * kRoom - 0.2);
      const double y = stream.uniform(0.2, kRoom - 0.2);
      const double quarter = std::floor(stream.uniform(0.0, 4.0)) * std::acos(-1.0) / 2.0;
      const Pose at = turnedAt({x, y, 0.0}, quarter, {0, 0, 1});
      const Box3 box = boundingBox(piece, at);
      const bool inside = box.min().x() > room * kRoom + 0.1 && box.max().x() < (room + 1) * kRoom - 0.1 &&
                          box.min().y() > 0.02 && box.max().y() < kRoom - 0.02;
      const bool free =
          std::none_of(kept.begin(), kept.end(), [&](const Box3& other) { return other.intersects(box); });
      if (!inside || !free) continue;
      append(target, transformed(piece, at));
      kept.push_back(box);
      ++placed;
    }
  }
}

inline MadeProblem throughRooms(const std::string& name, const std::string& description, int rooms, double door,
                                int perRoom, const TriangleMesh& object, std::uint64_t seed) {
  constexpr double kOverFloor = 0.03;
  RandomStream stream(seed, "rooms");
  Flat flat = flatOf(rooms, door, stream);
  const Pose start = Pose::translation({1.4, kRoom - 1.4, kOverFloor});
  const Pose goal = turnedAt({rooms * kRoom - 1.4, 1.4, kOverFloor}, std::acos(-1.0), {0, 0, 1});
  std::vector<Box3> kept{boundingBox(object, start), boundingBox(object, goal)};
  for (std::size_t i = 0; i < flat.doors.size(); ++i) {
    const Vector3 middle((static_cast<double>(i) + 1.0) * kRoom, flat.doors[i], 1.0);
    kept.emplace_back(Vector3(middle - Vector3(0.9, 0.6, 1.0)), Vector3(middle + Vector3(0.9, 0.6, 1.0)));
  }
  furnish(rooms, perRoom, kept, stream, flat.walls);
  return {name,
          description,
          object,
          std::move(flat.walls),
          start,
          goal,
          Box3(Vector3::Zero(), Vector3(rooms * kRoom, kRoom, kCeiling))};
}

inline MadeProblem sofaThroughRooms(std::uint64_t seed) {
  return throughRooms("rooms-sofa-" + std::to_string(seed), "A corner sofa through a door of 0.9 m, past furniture.", 2,
                      0.9, 4, cornerSofa(), seed);
}

inline MadeProblem tableThroughRooms(std::uint64_t seed) {
  return throughRooms("rooms-table-" + std::to_string(seed),
                      "A table of 1.6 by 0.9 m through two doors of 0.8 m, past furniture.", 3, 0.8, 6,
                      table(1.6, 0.9, 0.75), seed);
}

}  // namespace glissade::made
