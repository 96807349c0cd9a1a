#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TDF_Label.hxx>
#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/assembly/node_names.h"

namespace glissade {

/// What a STEP file calls its products and their uses, from its entities. OpenCASCADE keeps one name of products with
/// one shape (a mapped item), and one text of a use. Refers to nothing of the reader.
class StepNames {
 public:
  /// After the transfer.
  explicit StepNames(STEPCAFControl_Reader& reader);

  /// Of a product that no assembly uses; nothing where it has no shape of its own.
  std::optional<std::string> ofRoot(const TDF_Label& product) const;

  /// Of the uses of products in an assembly, where it has them; nothing for a shape that is no use.
  std::vector<std::optional<NodeNames>> ofUses(const TDF_Label& assembly, const std::vector<TopoDS_Shape>& uses) const;

 private:
  struct Use {
    TopoDS_Shape shape;
    NodeNames names;
  };

  std::unordered_map<std::string, std::vector<Use>> usesIn_;      ///< by the entry of the assembly's label
  std::unordered_map<std::string, std::vector<Use>> productsAt_;  ///< by the entry of their label; without a use
};

}  // namespace glissade
