#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/report.h"
#include "engine/scenario/fit_options.h"
#include "engine/scenario/part_files.h"

namespace glissade::cli {

struct NewOptions {
  std::string output;
  std::vector<std::string> moving;  ///< as usualPart() takes them, like those below; several move as one
  std::vector<std::string> statics;
  std::vector<std::string> mobiles;
  std::vector<std::string> without{};  ///< bodies that are left out
  std::optional<double> unit;          ///< metres per unit of the files; none: as their kind or their size says
  std::optional<UpAxis> up;
  double deflection = 0.0;  ///< of STEP files, metres; 0: by the size of each part
  bool closeHoles = false;  ///< of meshes, where they are planar
  bool groups = false;      ///< of OBJ files are parts
  FitOptions fits;          ///< on unless they are turned off
  bool clear = false;       ///< move the start clear of what it touches
  Format format = Format::Text;
};

/// glissade-cli new: a scenario of part files, one of which is to come out.
int runNew(const NewOptions& options);

}  // namespace glissade::cli
