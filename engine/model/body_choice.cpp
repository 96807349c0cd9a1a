#include "engine/model/body_choice.h"

#include <algorithm>

#include "engine/model/body_path.h"

namespace glissade {

std::vector<std::size_t> bodiesMeant(const std::vector<BodyId>& ids, const std::string& name, const Product& product) {
  std::vector<std::size_t> bodies;
  if (name.empty()) return bodies;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (isMeantBy(name, ids[i].text())) bodies.push_back(i);
  }
  if (!bodies.empty()) return bodies;
  const std::vector<BodyId> meant = bodiesMeant(product, name);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (std::binary_search(meant.begin(), meant.end(), ids[i])) bodies.push_back(i);
  }
  return bodies;
}

Result<std::vector<bool>> bodiesMeant(const std::vector<BodyId>& ids, const std::vector<std::string>& names,
                                      const std::string& option, const Product& product) {
  std::vector<bool> meant(ids.size(), false);
  for (const std::string& name : names) {
    const std::vector<std::size_t> bodies = bodiesMeant(ids, name, product);
    for (const std::size_t body : bodies) meant[body] = true;
    if (!bodies.empty()) continue;
    return Diagnostic{ErrorKind::Usage,
                      "",
                      option,
                      {GLISSADE_TEXT("names '%1', which is not a body of the product"), {name}},
                      GLISSADE_TEXT("See 'glissade-cli fits' for the names.")};
  }
  if (!ids.empty() && std::find(meant.begin(), meant.end(), false) == meant.end()) {
    return Diagnostic{ErrorKind::Usage, "", option, GLISSADE_TEXT("leaves no body"),
                      GLISSADE_TEXT("Name fewer bodies.")};
  }
  return meant;
}

Result<std::vector<bool>> bodiesMeant(const std::vector<BodyId>& ids, const std::vector<std::string>& names,
                                      const std::string& option) {
  return bodiesMeant(ids, names, option, Product());
}

}  // namespace glissade
