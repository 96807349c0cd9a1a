#pragma once

#include <string>

#include "engine/places/place_identifier.h"

namespace glissade {

/// A region of similar narrowness (paper 2, section 3.2). Its number is its index in the map.
struct Place {
  std::string name;                  ///< "P1"...: number in the order of the map
  std::vector<std::size_t> cells;    ///< cells of the grid, ascending
  Box3 box;                          ///< bounding box of the cells, world frame
  Vector3 anchor = Vector3::Zero();  ///< the widest point: inside the place, for binding edits
  double narrowness = 0.0;  ///< diameter of the largest ball about the anchor that meets no static body, metres
  int complexity = 1;       ///< 1 for the widest places; one more for each halving of the narrowness
  bool passage = false;     ///< true for a doorway (passages.h), whose axis is `axis`
  int axis = 0;             ///< for a passage: the world axis along which it is crossed
  double volume = 0.0;      ///< volume, cubic metres
};

/// The border of two places: the cells in which they overlap (paper 2, section 5.1.2). Two places that meet at several
/// spots have several borders.
struct Border {
  std::string name;  ///< "B1-6", or "B1-6b" for the second one
  int placeA = 0;    ///< index of the lower place
  int placeB = 0;
  std::vector<std::size_t> cells;     ///< cells of the overlap, ascending
  Vector3 centre = Vector3::Zero();   ///< centre of the faces that the two places share, world frame
  Vector3 normal = Vector3::UnitX();  ///< unit vector from A to B, mean of the shared faces' normals
  double opening = 0.0;               ///< area of the shared faces, square metres
};

/// The topological layer: places and borders of the static environment. Names and order depend on the geometry only, so
/// that they are the same in every run.
struct TopologicalMap {
  CellGrid grid;
  PlaceLabels placeOf;  ///< place of each cell
  std::vector<Place> places;
  std::vector<Border> borders;

  /// The place that holds a point; kNoPlace for cells with static bodies, or outside the workspace.
  int placeAt(const Vector3& p_W) const;
  /// The place of the nearest cell that belongs to one.
  int placeNear(const Vector3& p_W) const;
};

/// Places in the order of complexity, then along x, y, z. `statics_W` are the static bodies, in the
/// world, on which clearances are measured. Unfinished after a stop.
TopologicalMap makeTopologicalMap(const FreeSpace& space, const PlaceLabels& labels,
                                  const std::vector<double>& clearance, const std::vector<Passage>& passages,
                                  const TriangleMesh& statics_W, const StopToken& stop = {});

}  // namespace glissade
