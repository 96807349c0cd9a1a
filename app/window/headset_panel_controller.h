#pragma once

#include <QDialog>
#include <QPointer>

#include <functional>
#include <memory>
#include <vector>

#include "app/window/hand_tools.h"
#include "app/window/headset_panel_view.h"
#include "app/window/headset_texts.h"
#include "app/window/instruction_walk.h"
#include "app/window/workbench.h"
#include "widgets/panels/headset_page.h"

namespace glissade {

class RefusalController;
class SequenceController;

/// Errors and questions of the window, which a person with a headset does not see: the page asks them, and answers are
/// given to the dialog in the window. Of dialogs that are more than a message, the page has the title only, and closes
/// them.
class HeadsetQuestions final : public QObject {
 public:
  /// The page outlives this.
  explicit HeadsetQuestions(HeadsetPage& page);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();
  void answer(int chosen) const;

  HeadsetPage& page_;
  std::function<void()> showSoon_;
  std::vector<QPointer<QDialog>> open_;  ///< the last one is the one that is answered
};

/// What a person with a headset works with: the panel in the scene, texts, tools in the hands, the instruction. What
/// the panel says follows the run, the sequence and what was refused, and what is pressed there is done as in the
/// window. There is none before the headset is first asked for.
class HeadsetPanelController final : public QObject {
  Q_OBJECT

 public:
  HeadsetPanelController(const Workbench& bench, const RefusalController& refusal, SequenceController& sequence,
                         const MeasuringTools& measuring);

  /// Null before the headset was asked for.
  HeadsetPage* page() const { return page_.get(); }
  /// So often it was painted.
  int paintings() const { return view_ ? view_->paintings() : 0; }

 private:
  void make();
  void showScenario();
  void showRun();
  void showRefusal();
  void showStep();

  const Workbench& bench_;
  const RefusalController& refusal_;
  const SequenceController& sequence_;
  HeadsetToolsPtr tools_ = std::make_shared<HeadsetTools>();
  HeadsetTexts texts_;
  InstructionWalk walk_;
  HandTools handTools_;
  std::unique_ptr<HeadsetPage> page_;
  std::unique_ptr<HeadsetPanelView> view_;
  std::unique_ptr<HeadsetQuestions> questions_;
};

}  // namespace glissade
