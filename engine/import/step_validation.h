#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// Geometric validation properties that a STEP file states of a product: what its author's CAD system had measured.
struct StatedMeasures {
  std::string entity;                ///< "#45", of the first of them
  TopoDS_Shape shape;                ///< the product, at its own origin
  std::optional<double> volume{};    ///< cubic millimetres
  std::optional<double> area{};      ///< square millimetres
  std::optional<gp_Pnt> centroid{};  ///< millimetres, in the frame of the shape
};

/// Those of products; those of uses of products in assemblies are left out. Ask after the transfer. Runs in the
/// importing process only.
std::vector<StatedMeasures> statedMeasuresOf(const STEPCAFControl_Reader& reader);

}  // namespace glissade
