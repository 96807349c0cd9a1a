#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_TShape.hxx>
#include <map>
#include <string>

namespace glissade {

/// Names of the files with the products that a STEP file only places, by the shape that OpenCASCADE has made of the
/// product.
using ExternalFiles = std::map<const TopoDS_TShape*, std::string>;

/// Precondition: the transfer is done. If a product is in several files, the first STEP file counts, else the first
/// file. Runs in the importing process only.
ExternalFiles externalFilesOf(STEPCAFControl_Reader& reader);

}  // namespace glissade
