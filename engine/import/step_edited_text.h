#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/import/step_entities.h"

namespace glissade {

/// "#12".
inline std::string stepName(std::uint64_t id) { return "#" + std::to_string(id); }

/// A STEP text with replaced and added entities.
class StepEditedText {
 public:
  explicit StepEditedText(const StepEntities& entities);

  bool isEdited() const { return !replaced_.empty() || !added_.empty(); }
  /// `entity`: "PLANE('',#3)". Precondition: the text has an entity with this number.
  void replace(std::uint64_t id, const std::string& entity);
  /// Returns the name of the new entity.
  std::string add(const std::string& entity);
  std::string text() const;

 private:
  const StepEntities& entities_;
  std::uint64_t next_ = 1;  ///< number of the next added entity
  std::map<std::uint64_t, std::string> replaced_;
  std::string added_;
};

}  // namespace glissade
