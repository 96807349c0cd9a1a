#pragma once

#include <string>

#include "engine/environment/place_identifier.h"

namespace glissade {

/// A region of similar narrowness (paper 2, section 3.2). Its number is its index in the map.
struct Place {
  std::string name;                  ///< "P1"...: in the order of the map
  std::vector<std::size_t> cells;    ///< of the grid, ascending
  Box3 box;                          ///< around the cells, world
  Vector3 anchor = Vector3::Zero();  ///< the widest spot: inside the place, and where edits are bound to
  double narrowness = 0.0;  ///< diameter of the largest ball about the anchor that meets no static body, metres
  int complexity = 1;       ///< 1 for the widest places; one more each time the narrowness halves
  bool passage = false;     ///< a doorway (passages.h); its axis is `axis`
  int axis = 0;             ///< of a passage: the world axis along which it is crossed
  double volume = 0.0;      ///< cubic metres
};

/// Where two places meet: the cells in which they overlap (paper 2, section 5.1.2). Two places that
/// meet in several spots have several borders.
struct Border {
  std::string name;  ///< "B1-6"; "B1-6b" for the second one
  int placeA = 0;    ///< index of a place, lower
  int placeB = 0;
  std::vector<std::size_t> cells;     ///< the overlap, ascending
  Vector3 centre = Vector3::Zero();   ///< of the faces that the two places share, world
  Vector3 normal = Vector3::UnitX();  ///< unit, from A to B, mean of the shared faces' normals
  double opening = 0.0;               ///< square metres of the shared faces
};

/// The topological layer: places and borders of the static environment. Names and order depend on
/// nothing but the geometry, so they are the same from run to run.
struct TopologicalMap {
  CellGrid grid;
  PlaceLabels placeOf;  ///< per cell
  std::vector<Place> places;
  std::vector<Border> borders;

  /// The place that holds a point; kNoPlace where static bodies are, or outside the workspace.
  int placeAt(const Vector3& p_W) const;
  /// The place of the nearest cell that has one.
  int placeNear(const Vector3& p_W) const;
};

/// Places in the order of complexity, then along x, y, z. `statics_W` are the static bodies, in the
/// world, on which clearances are measured. Unfinished after a stop.
TopologicalMap makeTopologicalMap(const FreeSpace& space, const PlaceLabels& labels,
                                  const std::vector<double>& clearance, const std::vector<Passage>& passages,
                                  const TriangleMesh& statics_W, const StopToken& stop = {});

}  // namespace glissade
