#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QStackedWidget>
#include <QStringList>
#include <QWidget>

#include "widgets/controls/action_catalogue.h"
#include "widgets/run/parameter_sliders.h"

namespace glissade {

/// The content of the panel in the scene of a headset, on three sheets: strategy, run, the parameters of interaction
/// and undo; the sequence; place, display and bodies. Reasons of refusals are below. It has the actions and the
/// parameters of the window. Everything is large enough to be pointed at with a hand, and nothing needs a keyboard or
/// opens a window.
class HeadsetPage final : public QWidget {
  Q_OBJECT

 public:
  /// Width of the page in pixels. If the panel is 40 cm wide and 60 cm from the eyes, a capital letter is 0.6 degrees
  /// high.
  static constexpr int kWidth = 1000;
  static constexpr int kHeight = 800;
  static constexpr int kTextPixels = 22;

  explicit HeadsetPage(const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  /// `status`: the state of the run, in words. Parameters that do not affect the strategy with the device are hidden.
  void setSnapshot(const SessionSnapshot& snapshot, const std::string& deviceId, const QString& status);
  /// Sets whether a replay is shown, which cannot be steered.
  void setReplayed(bool replayed);
  /// Lists the named views, at which the person can stand.
  void setViews(const QStringList& names);
  /// Shows the place in the sequence; empty: there is none.
  void setStep(const QString& place);
  /// Shows a refusal and its reason; empty: none.
  void setRefusal(const QString& what, const QString& why);
  /// Shows a question or a message over the whole page, which blocks everything else. Without answers it is removed.
  void ask(const QString& what, const QString& why, const QStringList& answers);

 signals:
  void commanded(const glissade::Command& command);
  /// The person has chosen this named view, by its index.
  void viewChosen(int view);
  /// The person has chosen this answer, by its index.
  void answered(int answer);

 private:
  QLayout* makeHead();
  QWidget* makeRunSheet(const ActionCatalogue& actions);
  QWidget* makeSequenceSheet(const ActionCatalogue& actions);
  QWidget* makeSceneSheet(const ActionCatalogue& actions);
  QLayout* makeStrategies();
  QLayout* makeRefusal();
  void makeQuestion();

  QStackedWidget* sheets_;
  QLabel* strategy_;
  QButtonGroup* strategies_;
  QLabel* status_;
  ParameterSliders* sliders_;
  QLayout* views_;
  QLabel* step_;
  QLabel* what_;
  QLabel* why_;
  QWidget* question_;
  QLabel* asked_;
  QLabel* details_;
  QLayout* answers_;
};

}  // namespace glissade
