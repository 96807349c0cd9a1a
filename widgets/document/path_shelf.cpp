#include "widgets/document/path_shelf.h"

#include <algorithm>
#include <utility>

#include "widgets/document/value_command.h"

namespace glissade {

namespace {

Diagnostic refused(const std::string& name, const Message& reason, const Message& advice) {
  return {ErrorKind::Usage, "", name, reason, advice};
}

}  // namespace

PathShelf::PathShelf(QUndoStack& undo, QObject* parent) : QObject(parent), undo_(undo) {}

void PathShelf::open(const KeptPaths& paths) { apply(paths); }

void PathShelf::apply(const KeptPaths& paths) {
  paths_ = paths;
  std::stable_partition(paths_.begin(), paths_.end(), [](const KeptPathPtr& path) { return path->pinned; });
  emit changed();
}

KeptPathPtr PathShelf::find(const std::string& name) const {
  const auto found =
      std::find_if(paths_.begin(), paths_.end(), [&name](const KeptPathPtr& path) { return path->name == name; });
  return found == paths_.end() ? nullptr : *found;
}

bool PathShelf::holds(const std::vector<PathPoint>& points) const {
  return std::any_of(paths_.begin(), paths_.end(),
                     [&points](const KeptPathPtr& path) { return hasPoints(*path, points); });
}

void PathShelf::push(const QString& text, KeptPaths after) {
  const auto take = [this](const KeptPaths& paths) { apply(paths); };
  undo_.push(new ValueCommand<KeptPaths>(text, paths_, std::move(after), take));
}

void PathShelf::keep(KeptPath path) {
  path.name = freePathName(paths_, path.name);
  KeptPaths after = paths_;
  after.push_back(std::make_shared<const KeptPath>(std::move(path)));
  push(tr("Keep a path"), std::move(after));
}

Outcome PathShelf::replace(const std::string& name, const QString& text,
                           const std::function<KeptPathPtr(KeptPath)>& change) {
  KeptPaths after = paths_;
  const auto found =
      std::find_if(after.begin(), after.end(), [&name](const KeptPathPtr& path) { return path->name == name; });
  if (found == after.end())
    return refused(name, GLISSADE_TEXT("there is no kept path of this name"), GLISSADE_TEXT("Choose one of the list."));
  const KeptPathPtr changedPath = change(**found);
  if (changedPath) {
    *found = changedPath;
  } else {
    after.erase(found);
  }
  push(text, std::move(after));
  return Done{};
}

Outcome PathShelf::rename(const std::string& name, const std::string& newName) {
  if (newName == name) return Done{};
  if (newName.empty()) return refused(name, GLISSADE_TEXT("the new name is empty"), GLISSADE_TEXT("Give a name."));
  if (find(newName))
    return refused(newName, GLISSADE_TEXT("another path has this name"), GLISSADE_TEXT("Give another name."));
  return replace(name, tr("Rename a path"), [&newName](KeptPath path) {
    path.name = newName;
    return std::make_shared<const KeptPath>(std::move(path));
  });
}

Outcome PathShelf::pin(const std::string& name, bool pinned) {
  return replace(name, pinned ? tr("Pin a path") : tr("Unpin a path"), [pinned](KeptPath path) {
    path.pinned = pinned;
    return std::make_shared<const KeptPath>(std::move(path));
  });
}

Outcome PathShelf::remove(const std::string& name) {
  return replace(name, tr("Remove a path"), [](const KeptPath&) { return KeptPathPtr(); });
}

}  // namespace glissade
