#pragma once

#include <QDialog>
#include <QPointer>

#include <functional>
#include <memory>
#include <vector>

#include "widgets/headset/hand_tools.h"
#include "widgets/headset/headset_page.h"
#include "widgets/headset/headset_panel_view.h"
#include "widgets/headset/headset_texts.h"
#include "widgets/headset/instruction_walk.h"
#include "widgets/workbench/named_views.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

class RefusalController;
class SequenceController;

/// Shows errors and questions of the window on the page, because a person with a headset does not see the window. The
/// answers go to the dialog in the window. For dialogs that are more than a message, the page shows only the title and
/// can close them.
class HeadsetQuestions final : public QObject {
 public:
  /// The page must outlive this object.
  explicit HeadsetQuestions(HeadsetPage& page);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();
  void answer(int chosen) const;

  HeadsetPage& page_;
  std::function<void()> showSoon_;
  std::vector<QPointer<QDialog>> open_;  ///< the page asks the last one
};

/// The tools of a person with a headset: the panel in the scene, texts, tools in the hands, the instruction. The panel
/// shows the run, the sequence and refusals, and its buttons act as those of the window. They are made when the headset
/// is first started.
class HeadsetPanelController final : public QObject {
  Q_OBJECT

 public:
  HeadsetPanelController(const Workbench& bench, const RefusalController& refusal, SequenceController& sequence,
                         const MeasuringTools& measuring);

  /// Null until the headset was first started.
  HeadsetPage* page() const { return page_.get(); }
  /// Sets the views that the page lists.
  void setViews(const NamedViews& views);
  /// The number of times that the page was painted.
  int paintings() const { return view_ ? view_->paintings() : 0; }

 signals:
  /// The person wants to stand where the camera of this view is.
  void viewChosen(const glissade::NamedView& view);

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
  NamedViews views_;
  std::unique_ptr<HeadsetPage> page_;
  std::unique_ptr<HeadsetPanelView> view_;
  std::unique_ptr<HeadsetQuestions> questions_;
};

}  // namespace glissade
