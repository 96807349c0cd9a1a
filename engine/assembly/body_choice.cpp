#include "engine/assembly/body_choice.h"

#include <algorithm>

#include "engine/assembly/body_path.h"

namespace glissade {

Result<std::vector<bool>> bodiesMeant(const std::vector<std::string>& ids, const std::vector<std::string>& names,
                                      const std::string& option) {
  std::vector<bool> meant(ids.size(), false);
  for (const std::string& name : names) {
    bool any = false;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (name.empty() || !isMeantBy(name, ids[i])) continue;
      meant[i] = true;
      any = true;
    }
    if (any) continue;
    return Diagnostic{ErrorKind::Usage, "", option, "names '" + name + "', which is not a body of the product",
                      "See 'glissade-cli fits' for the names."};
  }
  if (!ids.empty() && std::find(meant.begin(), meant.end(), false) == meant.end()) {
    return Diagnostic{ErrorKind::Usage, "", option, "leaves no body", "Name fewer bodies."};
  }
  return meant;
}

}  // namespace glissade
