#include "engine/import/step_part_file.h"

#include <algorithm>
#include <filesystem>

#include "engine/import/cad_kind.h"
#include "engine/import/safe_path.h"

namespace glissade {
namespace {

bool isFromAnotherMachine(const std::string& name) {
  return name.front() == '/' || (name.size() > 1 && name[1] == ':');
}

}  // namespace

FoundStepPart findStepPart(const std::string& productFolder, const std::string& inFolder, const std::string& named) {
  namespace fs = std::filesystem;
  std::string name = named;
  std::replace(name.begin(), name.end(), '\\', '/');
  if (!name.empty() && isFromAnotherMachine(name)) name = name.substr(name.find_last_of("/:") + 1);
  if (name.empty()) return {named, "", GLISSADE_TEXT("is not a file name")};
  FoundStepPart found{(fs::path(inFolder) / name).lexically_normal().generic_string(), "", {}};
  const auto file = resolveBelow(productFolder, found.name, "", "");
  std::error_code unknown;
  if (!file) {
    found.whyNot = GLISSADE_TEXT("is outside its folder");
  } else if (!fs::is_regular_file(*file, unknown)) {
    found.whyNot = GLISSADE_TEXT("is not there");
  } else if (!hasStepEnding(name)) {
    found.whyNot = GLISSADE_TEXT("is not a STEP file");
  } else {
    found.file = *file;
  }
  return found;
}

}  // namespace glissade
