#pragma once

#include <optional>

#include "engine/fits/axial_slabs.h"
#include "engine/fits/drive_shape.h"

namespace glissade {

/// The kind of a body by its shape about its main axis, before its surroundings are examined.
enum class TurnedKind {
  Screw,     ///< a solid shaft with a wider head at one end
  SetScrew,  ///< a solid shaft without a head, with a recess at one end
  Nut,       ///< a hole through a prism of six sides or four
  Ring,      ///< a hole through a round body: a washer, an insert, a bush, a race
  Rod        ///< a solid shaft
};

/// A body that is shaped about an axis, in the body's frame, metres.
struct TurnedShape {
  TurnedKind kind = TurnedKind::Rod;
  AxisLine axis;     ///< for a screw, from its tip to its head
  double low = 0.0;  ///< range along the axis, from its point
  double high = 0.0;
  double headLow = 0.0;  ///< height at which the shaft of a screw meets its head; `high` for other kinds
  double shaft = 0.0;    ///< outer radius of a screw's shaft or of a rod; 0 for a ring and a nut
  double hole = 0.0;     ///< radius of the hole of a ring and a nut
  double outer = 0.0;    ///< largest radius
  double recess = 0.0;   ///< depth of the recess of a screw
  int sides = 0;         ///< sides of the prism of a head or a nut; 0: none
  DriveShape drive{};
  std::vector<AxialSlab> slabs{};  ///< slabs about the axis

  double length() const { return high - low; }
};

/// Nothing if the mesh has no such shape. The axis is that of its longest cylinder, or the main axis of its surface.
std::optional<TurnedShape> turnedShapeOf(const TriangleMesh& mesh, const AxialMesh& axial);

/// The width across the flats of a hexagon that is wider than another part of the body, for a wrench: of a nozzle, a
/// fitting, a hollow screw. Metres; nothing if there is none.
std::optional<double> wrenchFlats(const TurnedShape& shape);

/// True if the shape is a screw with a round head of the proportions of ISO 4762 that is drawn without a recess.
/// `diameter`: of the thread, metres.
bool hasCapHead(const TurnedShape& shape, double diameter);

/// Teeth about the shaft, as of a knurl or a spline: it is pressed in. A thread has a crest or a few in each section.
bool hasTeeth(const TurnedShape& shape);

}  // namespace glissade
