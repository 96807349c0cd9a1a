#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace glissade {

/// `TYPE(arguments)` of a STEP entity; an entity with several types has several records.
struct StepRecord {
  std::string_view type;
  std::string_view arguments;  ///< without their parentheses
};

/// The entities of a STEP text (ISO 10303-21), parsed without OpenCASCADE. Refers to the text. Precondition:
/// faultOfStepText() finds no fault in it.
class StepEntities {
 public:
  struct Entity {
    std::uint64_t id = 0;
    std::size_t begin = 0;  ///< begin of "#12=…;" in the text
    std::size_t end = 0;    ///< position after the semicolon
  };

  explicit StepEntities(std::string_view text);

  const std::vector<Entity>& all() const { return entities_; }  ///< ordered by number
  const Entity* find(std::uint64_t id) const;                   ///< null if it does not exist
  /// Empty if there is no such entity.
  std::vector<StepRecord> recordsOf(std::uint64_t id) const;
  std::vector<StepRecord> recordsOf(const Entity& entity) const;

  /// The only type; empty if there are several. Quick.
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

/// The values of "(…)"; empty for other texts.
std::vector<std::string_view> stepList(std::string_view value);

/// The number in "#12"; 0 if the value is no reference.
std::uint64_t stepReference(std::string_view value);

/// All references in a text, in their order.
std::vector<std::uint64_t> stepReferencesIn(std::string_view text);

}  // namespace glissade
