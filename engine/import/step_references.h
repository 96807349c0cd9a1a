#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

/// The entities of a STEP text and what they refer to: `#12=CLOSED_SHELL('',(#7,#8));` is entity 12 with references
/// to 7 and 8. OpenCASCADE leaves out what a missing entity should have been, such as a face of a solid.
class StepReferences {
 public:
  /// Begins an entity; what is referred to next is referred to by it. `at`: where it stands in the text. `type` is
  /// part of the text.
  void beginEntity(std::uint64_t id, std::size_t at, std::string_view type);
  void refer(std::uint64_t id);

  struct Fault {
    std::size_t at;  ///< in the text
    std::string reason;
  };
  /// The first of: an entity that is there twice, a reference to an entity that is not there, entities that refer to
  /// each other in a circle. A REPRESENTATION may contain itself: sound files have that. Takes n log n of time.
  std::optional<Fault> fault();

 private:
  struct Entity {
    std::uint64_t id;
    std::size_t at;
    std::size_t references;  ///< index of the first
    std::string_view type;   ///< empty: of several types
  };

  std::optional<Fault> duplicate() const;
  std::optional<Fault> resolve();
  std::optional<Fault> circle() const;
  std::size_t endOfReferences(std::size_t entity) const;
  std::string shown(std::size_t entity) const;

  std::vector<Entity> entities_;
  std::vector<std::uint64_t> references_;  ///< ids; after resolve() indices of entities
};

}  // namespace glissade
