#pragma once

#include <QDialog>

#include <memory>
#include <vector>

#include "engine/planning/clearance_profile.h"
#include "widgets/paths/kept_paths_panel.h"

namespace glissade {

/// A path of the comparison.
struct ComparedPath {
  KeptPathRow row;
  std::shared_ptr<const ClearanceProfile> profile;  ///< null: not known, because the path is not valid here
};

/// Compares paths side by side: one column for each path with its figures, and their clearance curves on common scales.
class ComparePathsDialog final : public QDialog {
  Q_OBJECT

 public:
  ComparePathsDialog(const std::vector<ComparedPath>& paths, const LoadedScenario& scenario, QWidget* parent);
};

}  // namespace glissade
