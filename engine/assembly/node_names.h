#pragma once

#include <string>
#include <vector>

namespace glissade {

/// The names that a CAD file gives to a part or an assembly at the place where it is used. A name may be empty, hold a
/// "/", and be the name of a sibling, too.
struct NodeNames {
  std::string product{};     ///< the name of the part or assembly that is used
  std::string occurrence{};  ///< the name of the use, which may be a number that the exporter gave
  std::string designator{};  ///< reference designator of the use: "C4"

  friend bool operator==(const NodeNames&, const NodeNames&) = default;
};

/// Whether a name of the use says something that the product's name does not: it has a letter, and is neither the
/// product's name, with a number or without, nor a number or a key that exporters give ("NAUO1", "*DIT57", a UUID).
bool namesTheOccurrence(const std::string& name, const std::string& product);

/// The name that people see, before siblings are told apart: that of the occurrence, else the designator, else that of
/// the product. The first two count where they name the occurrence.
const std::string& shownName(const NodeNames& names);

/// The names of nodes that have only names of products: the steps of a path.
std::vector<NodeNames> productNames(const std::vector<std::string>& products);

}  // namespace glissade
