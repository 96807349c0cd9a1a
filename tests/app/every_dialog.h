// Makes all dialogs of the window as the window does.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "app/window/main_window.h"
#include "app/window/preferences_dialog.h"
#include "engine/files/product_file.h"
#include "widgets/contacts/joint_dialog.h"
#include "widgets/contacts/joint_draft.h"
#include "widgets/devices/calibration_dialog.h"
#include "widgets/devices/head_dialog.h"
#include "widgets/help/command_palette.h"
#include "widgets/help/manual_browser.h"
#include "widgets/help/shortcuts_dialog.h"
#include "widgets/paths/compare_paths_dialog.h"
#include "widgets/places/attribute_dialog.h"
#include "widgets/places/rules_dialog.h"
#include "widgets/product/parts_dialog.h"
#include "widgets/sequence/plan_graph_view.h"
#include "widgets/sequence/revision_controller.h"
#include "widgets/sequence/times_view.h"
#include "widgets/view/named_views_dialog.h"
#include "widgets/view/stereo_dialog.h"

namespace glissade::test {

class EveryDialog {
 public:
  /// Precondition: a scenario is open in the window.
  explicit EveryDialog(MainWindow& window) {
    const Workbench& bench = window.workbench();
    const LoadedScenario& loaded = *bench.document.scenario();
    dialogs_.push_back(std::make_unique<PreferencesDialog>(bench.actions, Preferences{}, &window));
    auto stereo = std::make_unique<StereoDialog>(bench.actions, StereoSettings{}, &window);
    stereo->showPictureSize({0.3, 0.2});
    dialogs_.push_back(std::move(stereo));
    dialogs_.push_back(std::make_unique<ShortcutsDialog>(bench.actions, &window));
    dialogs_.push_back(std::make_unique<CommandPalette>(bench.actions, &window));
    dialogs_.push_back(std::make_unique<RulesDialog>(StrategyRules{}, AttributeTable{}, &window));
    dialogs_.push_back(std::make_unique<AttributeDialog>(
        AttributeOwner::Place, [](const AttributeDefinition&) { return Outcome(Done{}); }, &window));
    dialogs_.push_back(std::make_unique<PartsDialog>(PartsDialog::Purpose::NewScenario, QStringList{}, true, &window));
    dialogs_.push_back(std::make_unique<ComparePathsDialog>(
        std::vector<ComparedPath>(2, {{std::make_shared<const KeptPath>(), {}}, nullptr}), loaded, &window));
    const auto product = std::make_shared<const AssembledProduct>(productOf(loaded));
    dialogs_.push_back(std::make_unique<JointDialog>(
        product, draftJoint(*product, {0, 1, 2}), [](const Joint&) { return Outcome(Done{}); }, &window));
    dialogs_.push_back(std::make_unique<PlanGraphView>(&window));
    dialogs_.push_back(std::make_unique<TimesView>(&window));
    auto times = std::make_unique<TimesView>(&window);
    times->showTable();
    dialogs_.push_back(std::move(times));
    dialogs_.push_back(std::make_unique<CalibrationDialog>(bench.session.hand(), settings_, bench.actions, &window));
    dialogs_.push_back(std::make_unique<HeadDialog>(
        HeadPreferences{}, [] { return HeadState{}; }, &window));
    dialogs_.push_back(std::make_unique<NamedViewsDialog>(NamedViews{}, &window));
    dialogs_.emplace_back(makeRevisionDialog(QStringLiteral("bracket-2.step"),
                                             {QStringLiteral("moved: bolt by 2 mm"), QStringLiteral("no step: bolt")},
                                             &window));
  }

  const std::vector<std::unique_ptr<QWidget>>& dialogs() const { return dialogs_; }

 private:
  DeviceSettings settings_;
  std::vector<std::unique_ptr<QWidget>> dialogs_;
};

}  // namespace glissade::test
