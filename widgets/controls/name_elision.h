#pragma once

#include <QFontMetrics>
#include <QStringList>

#include <vector>

namespace glissade {

/// Shortens the names of a list so that they are still told apart: "…assembly_1/…assembly_2/nut" for a nut with
/// namesakes in other assemblies. A number is kept as a whole or left out.
class NameElision {
 public:
  explicit NameElision(const QStringList& names = {});

  /// The name in at most `width` pixels if it fits, else the shortest text that tells it from the other names.
  QString elided(const QString& name, const QFontMetrics& metrics, int width) const;

 private:
  using Kept = std::vector<bool>;  ///< for each letter of a name

  Kept distinctLetters(const QString& name) const;

  QStringList reversed_;  ///< the names from their ends, sorted, each once
};

}  // namespace glissade
