#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// Geometric validation properties that a STEP file states for a product: measurements of the author's CAD system.
struct StatedMeasures {
  std::string entity;                ///< "#45", the entity of the first property
  TopoDS_Shape shape;                ///< the product, at its origin
  std::optional<double> volume{};    ///< cubic millimetres
  std::optional<double> area{};      ///< square millimetres
  std::optional<gp_Pnt> centroid{};  ///< millimetres, in the frame of the shape
};

/// The properties of products; those of uses of products in assemblies are left out. Precondition: the transfer is
/// done. Runs in the importing process only.
std::vector<StatedMeasures> statedMeasuresOf(const STEPCAFControl_Reader& reader);

}  // namespace glissade
