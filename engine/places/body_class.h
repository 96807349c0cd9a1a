#pragma once

#include <string>
#include <vector>

#include "engine/places/attribute.h"

namespace glissade {

/// A class of bodies. It has its parent's attributes, overridden by its own.
struct BodyClass {
  std::string name;        ///< name in files: "socket_head_screw"
  std::string of{};        ///< name of the parent; empty: none
  std::string label{};     ///< name for people
  std::string fastener{};  ///< kind of fastener of its bodies; empty: that of the parent, or by shape
  Attributes attributes{};

  friend bool operator==(const BodyClass&, const BodyClass&) = default;
};

/// A tree of classes.
class BodyClasses {
 public:
  /// Makes the tree. A class replaces an earlier one of the same name. Errors, MalformedInput with the class in the
  /// reason: an unknown parent, parents in a circle.
  static Result<BodyClasses> of(const std::vector<BodyClass>& classes);

  /// The class with this name; null where there is none.
  const BodyClass* find(const std::string& name) const;
  /// Attributes of a class, including inherited ones. Precondition: the class exists.
  Attributes attributesOf(const std::string& name) const;
  /// Kind of fastener of a class, or the inherited one; empty: none. Precondition: the class exists.
  std::string fastenerOf(const std::string& name) const;
  const std::vector<BodyClass>& all() const { return classes_; }

 private:
  std::vector<BodyClass> classes_;
};

}  // namespace glissade
