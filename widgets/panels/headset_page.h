#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QStringList>
#include <QWidget>

#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/parameter_sliders.h"

namespace glissade {

/// What the panel in the scene of a headset shows: strategy, run, the parameters of interaction, undo, the steps of the
/// sequence, and why something was refused. It has the actions and the parameters of the window. Everything is large
/// enough to be pointed at with a hand, and nothing needs a keyboard or opens a window.
class HeadsetPage final : public QWidget {
  Q_OBJECT

 public:
  /// Pixels, of the page and of its texts. Where the panel is 40 cm wide and 60 cm from the eyes, a capital letter is
  /// 0.6 degrees high.
  static constexpr int kWidth = 1000;
  static constexpr int kHeight = 800;
  static constexpr int kTextPixels = 22;

  explicit HeadsetPage(const ActionCatalogue& actions, QWidget* parent = nullptr);

  void setScenario(const LoadedScenario& scenario);
  /// `status`: what happens, in words.
  void setSnapshot(const SessionSnapshot& snapshot, const QString& status);
  /// What is shown is a replay: nothing can be steered.
  void setReplayed(bool replayed);
  /// Where in the sequence the scene is; empty: there is none.
  void setStep(const QString& place);
  /// What was refused and why; empty: nothing.
  void setRefusal(const QString& what, const QString& why);
  /// What is asked or said before anything else can be done, over the whole page; without answers: nothing.
  void ask(const QString& what, const QString& why, const QStringList& answers);

 signals:
  void commanded(const glissade::Command& command);
  /// By its place among the answers.
  void answered(int answer);

 private:
  QLayout* makeStrategies();
  QLayout* makeSequence(const ActionCatalogue& actions);
  QLayout* makeRefusal();
  void makeQuestion();

  QLabel* strategy_;
  QButtonGroup* strategies_;
  QLabel* status_;
  ParameterSliders* sliders_;
  QWidget* sequence_;
  QLabel* step_;
  QLabel* what_;
  QLabel* why_;
  QWidget* question_;
  QLabel* asked_;
  QLabel* details_;
  QLayout* answers_;
};

}  // namespace glissade
