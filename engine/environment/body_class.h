#pragma once

#include <string>
#include <vector>

#include "engine/environment/attribute.h"

namespace glissade {

/// A class of bodies. It has what its parent has, and what it says itself.
struct BodyClass {
  std::string name;        ///< in files: "socket_head_screw"
  std::string of{};        ///< name of the parent; empty: none
  std::string label{};     ///< for people
  std::string fastener{};  ///< kind of fastener that its bodies are; empty: as the parent, or by shape
  Attributes attributes{};

  friend bool operator==(const BodyClass&, const BodyClass&) = default;
};

/// A tree of classes.
class BodyClasses {
 public:
  /// A class that comes later takes the place of one of the same name. Errors, MalformedInput with the class in the
  /// reason: an unknown parent, parents in a circle.
  static Result<BodyClasses> of(const std::vector<BodyClass>& classes);

  /// Null where there is none.
  const BodyClass* find(const std::string& name) const;
  /// Its own, and those that it inherits. Precondition: the class is there.
  Attributes attributesOf(const std::string& name) const;
  /// Its own kind of fastener, or the one that it inherits; empty: none. Precondition: the class is there.
  std::string fastenerOf(const std::string& name) const;
  const std::vector<BodyClass>& all() const { return classes_; }

 private:
  std::vector<BodyClass> classes_;
};

}  // namespace glissade
