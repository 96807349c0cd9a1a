#include "engine/assembly/body_choice.h"

#include <algorithm>

#include "engine/assembly/product_tree.h"

namespace glissade {
Result<std::vector<bool>> bodiesMeant(const std::vector<std::string>& ids, const std::vector<std::string>& names,
                                      const std::string& option) {
  const ProductTree tree(ids);
  std::vector<bool> meant(ids.size(), false);
  for (const std::string& name : names) {
    const std::vector<std::size_t> nodes = tree.named(name);
    for (const std::size_t node : nodes) {
      for (const std::size_t body : tree.bodiesOf(node)) meant[body] = true;
    }
    if (!nodes.empty()) continue;
    return Diagnostic{ErrorKind::Usage, "", option, "names '" + name + "', which is not a body of the product",
                      "See 'glissade-cli fits' for the names."};
  }
  if (!ids.empty() && std::find(meant.begin(), meant.end(), false) == meant.end()) {
    return Diagnostic{ErrorKind::Usage, "", option, "leaves no body", "Name fewer bodies."};
  }
  return meant;
}

}  // namespace glissade
