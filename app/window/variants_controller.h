#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/window/workbench.h"
#include "widgets/bridge/background_task.h"
#include "widgets/editors/variants_dialog.h"
#include "widgets/panels/notice_bar.h"

namespace glissade {

/// Finds bodies of the product that fill the same place, says so over the scene, and asks which of them are built. What
/// is not is left out, as one undoable edit.
class VariantsController final : public QObject {
  Q_OBJECT

 public:
  explicit VariantsController(const Workbench& bench);

 private:
  /// Bodies by number in rigidBodiesOf() the scenario, of each place.
  using Places = std::vector<std::vector<std::size_t>>;

  void followDocument(Changes what);
  void find();
  void take(const Places& places);
  void ask();
  void leaveOthersOut(const std::set<std::string>& rigidIds);
  /// The body alone, as large as it can be.
  QImage pictureOf(const std::string& rigidId, const Box3& box);
  void addCommands();

  const Workbench& bench_;
  NoticeBar* bar_;
  BackgroundTask task_;
  std::vector<std::string> known_;  ///< ids of the bodies that were looked at
  Places places_;                   ///< that were found
};

}  // namespace glissade
