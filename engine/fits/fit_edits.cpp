#include "engine/fits/fit_edits.h"

#include <algorithm>

namespace glissade {

FitEdit& editOf(const BodyId& a, const BodyId& b, FitSettings& settings) {
  const auto found = std::find_if(settings.pairs.begin(), settings.pairs.end(), [&](const FitEdit& edit) {
    return (edit.a == a && edit.b == b) || (edit.a == b && edit.b == a);
  });
  if (found != settings.pairs.end()) return *found;
  settings.pairs.push_back({a, b, std::nullopt, std::nullopt, false});
  return settings.pairs.back();
}

}  // namespace glissade
