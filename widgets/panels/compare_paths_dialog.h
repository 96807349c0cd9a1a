#pragma once

#include <QDialog>

#include <memory>
#include <vector>

#include "engine/planning/clearance_profile.h"
#include "widgets/panels/kept_paths_panel.h"

namespace glissade {

/// What is compared of a path.
struct ComparedPath {
  KeptPathRow row;
  std::shared_ptr<const ClearanceProfile> profile;  ///< null: not known, because it does not hold here
};

/// Paths side by side: a column each, with their figures and their clearance as curves with one scale each.
class ComparePathsDialog final : public QDialog {
  Q_OBJECT

 public:
  ComparePathsDialog(const std::vector<ComparedPath>& paths, const LoadedScenario& scenario, QWidget* parent);
};

}  // namespace glissade
