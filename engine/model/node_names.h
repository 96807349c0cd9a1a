#pragma once

#include <string>
#include <vector>

namespace glissade {

/// The names that a CAD file gives to a part or an assembly at the place of its use. A name may be empty, contain a
/// "/", and be equal to that of a sibling.
struct NodeNames {
  std::string product{};     ///< name of the part or assembly that is used
  std::string occurrence{};  ///< name of the use, which may be a number by the exporter
  std::string designator{};  ///< reference designator of the use: "C4"

  friend bool operator==(const NodeNames&, const NodeNames&) = default;
};

/// True if a name of the use adds to the product's name: it has a letter, and is neither the product's name, with or
/// without a number, nor a number or a key of an exporter ("NAUO1", "*DIT57", a UUID).
bool namesTheOccurrence(const std::string& name, const std::string& product);

/// The name for people, before siblings are distinguished: that of the occurrence, else the designator, else that of
/// the product. The first two count only if namesTheOccurrence() holds.
const std::string& shownName(const NodeNames& names);

/// The names of nodes that only have names of products, from the steps of a path.
std::vector<NodeNames> productNames(const std::vector<std::string>& products);

}  // namespace glissade
