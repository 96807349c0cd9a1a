#pragma once

#include <optional>

#include "engine/product/axial_slabs.h"
#include "engine/product/drive_shape.h"

namespace glissade {

/// What a body may be by its shape about its main axis, before what is around it is asked.
enum class TurnedKind {
  Screw,     ///< a solid shaft with a wider head at one end
  SetScrew,  ///< a solid shaft without a head, with a recess at one end
  Nut,       ///< a hole through a prism of six sides or four
  Ring,      ///< a hole through what is round: a washer, an insert, a bush, a race
  Rod        ///< a solid shaft
};

/// In the body's frame, metres.
struct TurnedShape {
  TurnedKind kind = TurnedKind::Rod;
  AxisLine axis;     ///< of a screw from its tip to its head
  double low = 0.0;  ///< extent along the axis, from its point
  double high = 0.0;
  double headLow = 0.0;  ///< where the shaft of a screw meets its head; of others `high`
  double shaft = 0.0;    ///< radius of a screw and a rod outside; 0 of a ring and a nut
  double hole = 0.0;     ///< radius of the hole of a ring and a nut
  double outer = 0.0;    ///< largest radius
  double recess = 0.0;   ///< depth of the recess of a screw
  int sides = 0;         ///< of the prism that the head or the nut is; 0: none
  DriveShape drive{};
  std::vector<AxialSlab> slabs{};  ///< about the axis

  double length() const { return high - low; }
};

/// Nothing where the mesh has no such shape. The axis is that of its longest cylinder, or the main axis of its surface.
std::optional<TurnedShape> turnedShapeOf(const TriangleMesh& mesh, const AxialMesh& axial);

/// The width across the flats of a hexagon that is wider than another part of the body, for a wrench: of a nozzle, a
/// fitting, a hollow screw. Nothing where it has none. Metres.
std::optional<double> wrenchFlats(const TurnedShape& shape);

}  // namespace glissade
