#pragma once

#include <set>
#include <string>
#include <vector>

#include "widgets/controls/background_task.h"
#include "widgets/controls/notice_bar.h"
#include "widgets/product/variants_dialog.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// Finds bodies of the product that fill the same place, shows them over the scene, and asks which of them are built.
/// The others are left out by one undoable edit.
class VariantsController final : public QObject {
  Q_OBJECT

 public:
  explicit VariantsController(const Workbench& bench);

 private:
  /// For each place, the indices of its bodies in rigidBodiesOf() the scenario.
  using Places = std::vector<std::vector<std::size_t>>;

  void followDocument(Changes what);
  void find();
  void take(const Places& places);
  void ask();
  void leaveOthersOut(const std::set<BodyId>& rigidIds);
  /// Picture of the body alone, as large as possible.
  QImage pictureOf(const BodyId& rigidId, const Box3& box);
  void addCommands();

  const Workbench& bench_;
  NoticeBar* bar_;
  BackgroundTask task_;
  std::vector<BodyId> known_;  ///< the examined bodies
  Places places_;              ///< the places that were found
};

}  // namespace glissade
