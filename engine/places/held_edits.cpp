#include "engine/places/held_edits.h"

#include <algorithm>

namespace glissade {

SemanticEdits heldEdits(SemanticEdits edits, const Product& product) {
  const auto isAssembly = [&](const std::string& id) {
    const auto node = product.find(id);
    return node && product.nodes()[*node].isAssembly;
  };
  const bool any = std::any_of(edits.bodies.begin(), edits.bodies.end(),
                               [&](const auto& edited) { return isAssembly(edited.first); });
  if (!any) return edits;
  std::vector<Attributes> handedDown(product.nodes().size());
  for (std::size_t i = 0; i < product.nodes().size(); ++i) {
    const Product::Node& node = product.nodes()[i];
    const Attributes inherited = node.parent ? handedDown[*node.parent] : Attributes{};
    if (!node.isAssembly) {
      if (!inherited.empty()) edits.bodies[node.id].insert(inherited.begin(), inherited.end());
      continue;
    }
    if (const auto own = edits.bodies.extract(node.id)) handedDown[i] = std::move(own.mapped());
    handedDown[i].insert(inherited.begin(), inherited.end());
  }
  return edits;
}

}  // namespace glissade
