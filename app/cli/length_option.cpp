#include "app/cli/length_option.h"

#include <CLI/CLI.hpp>

#include "engine/base/limits.h"
#include "engine/base/quantity_text.h"

namespace glissade::cli {

double metres(const std::string& text) {
  const auto length = toMetres(text, 1.0);
  if (!length) {
    throw CLI::ValidationError("'" + text +
                               "' is not a length: give metres, or a unit as in 0.5mm (m, cm, mm, in, ft)");
  }
  if (!limits::isCoordinate(*length)) {
    throw CLI::ValidationError("'" + text + "' is beyond 1e9 m: check the unit");
  }
  return *length;
}

}  // namespace glissade::cli
