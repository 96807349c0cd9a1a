#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/message.h"

namespace glissade {

/// The entities of a STEP text and their references: `#12=CLOSED_SHELL('',(#7,#8));` is entity 12 with references to 7
/// and 8. OpenCASCADE silently leaves out objects of missing entities, such as a face of a solid.
class StepReferences {
 public:
  /// Begins an entity, to which the following references belong. `at`: position in the text. `type`: part of the text.
  void beginEntity(std::uint64_t id, std::size_t at, std::string_view type);
  void refer(std::uint64_t id);

  struct Fault {
    std::size_t at;  ///< position in the text
    Message reason;
  };
  /// The first fault: an entity that exists twice, a reference to a missing entity, or entities that refer to each
  /// other in a circle. A REPRESENTATION may contain itself, as it does in valid files. Takes O(n log n) time.
  std::optional<Fault> fault();

 private:
  struct Entity {
    std::uint64_t id;
    std::size_t at;
    std::size_t references;  ///< index of the first reference
    std::string_view type;   ///< empty: several types
  };

  std::optional<Fault> duplicate() const;
  std::optional<Fault> resolve();
  std::optional<Fault> circle() const;
  std::size_t endOfReferences(std::size_t entity) const;
  std::string shown(std::size_t entity) const;

  std::vector<Entity> entities_;
  std::vector<std::uint64_t> references_;  ///< ids; indices of entities after resolve()
};

}  // namespace glissade
