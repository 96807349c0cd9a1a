#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TDF_Label.hxx>
#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/model/node_names.h"

namespace glissade {

/// The names that a STEP file gives to its products and their uses, read from its entities. OpenCASCADE keeps only one
/// name for products that share a shape (a mapped item), and only one text for a use. Does not refer to the reader.
class StepNames {
 public:
  /// Precondition: the transfer is done.
  explicit StepNames(STEPCAFControl_Reader& reader);

  /// The name of a product that no assembly uses; nothing if the product has no shape.
  std::optional<std::string> ofRoot(const TDF_Label& product) const;

  /// The names of these uses of products in an assembly, in their order; nothing for a shape that is no use.
  std::vector<std::optional<NodeNames>> ofUses(const TDF_Label& assembly, const std::vector<TopoDS_Shape>& uses) const;

 private:
  struct Use {
    TopoDS_Shape shape;
    NodeNames names;
  };

  std::unordered_map<std::string, std::vector<Use>> usesIn_;      ///< by the entry of the assembly's label
  std::unordered_map<std::string, std::vector<Use>> productsAt_;  ///< by the label of the product, without a use
};

}  // namespace glissade
