#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <map>
#include <string>

#include "engine/base/message.h"
#include "engine/import/step_stand_ins.h"
#include "engine/import/step_stated_shapes.h"

namespace glissade {

/// The small solids that stand in for tessellated shapes, as made by OpenCASCADE. Runs in the importing process only.
class StandInShapes {
 public:
  /// Precondition: the transfer is done. Takes the tessellations.
  StandInShapes() = default;
  StandInShapes(const STEPCAFControl_Reader& reader, StepStandIns standIns, const StatedShapes& stated);

  /// The triangles of the stand-in, in millimetres, at its origin; null: it is a solid of the file.
  const StepTessellation* of(const TopoDS_Shape& solid) const;

  /// The item of a stand-in that may be a second representation of its product's boundaries; null: it is no such solid.
  const StatedShape* maybeSecond(const TopoDS_Shape& solid) const;
  /// True if the shape belongs to the boundaries of a product that may have a second representation.
  bool isBoundaryOf(std::uint64_t product, const TopoDS_Shape& shape) const;

  /// The reason why the triangles of an item cannot be read; empty if they can.
  Message faultOf(std::uint64_t item) const;

 private:
  struct StandIn {
    StatedShape item;
    StepTessellation triangles;
  };

  void take(const StatedShape& item, StepTessellation triangles, const TopoDS_Shape& standIn);

  std::map<const TopoDS_TShape*, StandIn> standIns_;
  std::map<std::uint64_t, Message> faults_;
  std::map<const TopoDS_TShape*, std::uint64_t> boundaries_;  ///< products of solids and faces
};

}  // namespace glissade
