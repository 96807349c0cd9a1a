#pragma once

#include <QObject>
#include <QUndoStack>

#include <functional>

#include "engine/base/result.h"
#include "engine/files/kept_path.h"

namespace glissade {

/// The paths that are kept in the open scenario. Every change is a command on the document's undo stack. Used on the
/// GUI thread only; the paths themselves never change.
class PathShelf final : public QObject {
  Q_OBJECT

 public:
  explicit PathShelf(QUndoStack& undo, QObject* parent = nullptr);

  /// Takes the paths of another scenario.
  void open(const KeptPaths& paths);
  /// The kept paths: pinned ones first, in the order in which they were kept.
  const KeptPaths& paths() const { return paths_; }
  /// Null if no path has this name.
  KeptPathPtr find(const std::string& name) const;
  /// Whether a kept path has these configurations.
  bool holds(const std::vector<PathPoint>& points) const;

  /// Keeps the path under its name, or under a free name that begins with it.
  void keep(KeptPath path);
  /// Refused (Usage): an empty name, the name of another path, or no path of this name.
  Outcome rename(const std::string& name, const std::string& newName);
  Outcome pin(const std::string& name, bool pinned);
  Outcome remove(const std::string& name);

 signals:
  void changed();

 private:
  void apply(const KeptPaths& paths);
  void push(const QString& text, KeptPaths after);
  /// Pushes a command that replaces one path; a null pointer removes it.
  Outcome replace(const std::string& name, const QString& text, const std::function<KeptPathPtr(KeptPath)>& change);

  QUndoStack& undo_;
  KeptPaths paths_;
};

}  // namespace glissade
