#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/import/step_entities.h"

namespace glissade {

/// "#12".
inline std::string stepName(std::uint64_t id) { return "#" + std::to_string(id); }

/// A STEP text with some of its entities replaced, and some added.
class StepEditedText {
 public:
  explicit StepEditedText(const StepEntities& entities);

  bool isEdited() const { return !replaced_.empty() || !added_.empty(); }
  /// `entity`: "PLANE('',#3)". Precondition: the text has one of this number.
  void replace(std::uint64_t id, const std::string& entity);
  /// Its name.
  std::string add(const std::string& entity);
  std::string text() const;

 private:
  const StepEntities& entities_;
  std::uint64_t next_ = 1;  ///< number of the next entity that is added
  std::map<std::uint64_t, std::string> replaced_;
  std::string added_;
};

}  // namespace glissade
