#pragma once

#include "app/window/workbench.h"
#include "widgets/panels/section_panel.h"

namespace glissade {

/// The section planes of the view, and their panel.
class SectionController final : public QObject {
  Q_OBJECT

 public:
  explicit SectionController(const Workbench& bench);

  SectionPanel* panel() const { return panel_; }

 private:
  Outcome setByScript(const ScriptCommands::Words& words);

  const Workbench& bench_;
  SectionPanel* panel_;
};

}  // namespace glissade
