#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace glissade {

/// `TYPE(arguments)` of a STEP entity; an entity of several types has several.
struct StepRecord {
  std::string_view type;
  std::string_view arguments;  ///< without their parentheses
};

/// The entities of a STEP text (ISO 10303-21) as the text has them, without OpenCASCADE. Refers to the text, which
/// faultOfStepText() has let pass.
class StepEntities {
 public:
  struct Entity {
    std::uint64_t id = 0;
    std::size_t begin = 0;  ///< of "#12=…;" in the text
    std::size_t end = 0;    ///< behind its semicolon
  };

  explicit StepEntities(std::string_view text);

  const std::vector<Entity>& all() const { return entities_; }  ///< by their numbers
  const Entity* find(std::uint64_t id) const;                   ///< null: it is not there
  /// None where there is no such entity.
  std::vector<StepRecord> recordsOf(std::uint64_t id) const;
  std::vector<StepRecord> recordsOf(const Entity& entity) const;

  /// Quick: the only type, or empty where it has several.
  std::string_view typeOf(const Entity& entity) const;

  std::string_view text() const { return text_; }
  /// The position at which entities can be added to the text.
  std::size_t endOfData() const { return endOfData_; }

 private:
  std::string_view text_;
  std::vector<Entity> entities_;
  std::size_t endOfData_ = 0;
};

/// The values between the commas of a record or a list, without blanks around them.
std::vector<std::string_view> stepValues(std::string_view arguments);

/// The values of "(…)"; none of what is no list.
std::vector<std::string_view> stepList(std::string_view value);

/// The number of "#12"; 0 where the value is no reference.
std::uint64_t stepReference(std::string_view value);

/// All references in a text, in their order.
std::vector<std::uint64_t> stepReferencesIn(std::string_view text);

}  // namespace glissade
