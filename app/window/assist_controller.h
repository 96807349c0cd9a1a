#pragma once

#include "app/window/scene_hint.h"
#include "app/window/workbench.h"
#include "widgets/panels/difficulty_panel.h"

namespace glissade {

/// The line over the scene for a person who steers: what the search asks of the hand, and the keys while a run goes on
/// by hand.
class HandHint final : public QObject {
  Q_OBJECT

 public:
  explicit HandHint(const Workbench& bench);

  /// Empty: nothing is asked.
  void ask(const QString& text);

 private:
  void write();
  QString keys() const;

  const Workbench& bench_;
  SceneHint* hint_;
  QString asked_;
  QString shown_;
};

/// Offers the places where a search does not get on, and takes the hand and the view there: in a run that the hand
/// takes part in, or in a new one where the last run found no path or nobody held the object. On screen, a run by hand
/// that does not end offers them by itself.
class AssistController final : public QObject {
  Q_OBJECT

 public:
  explicit AssistController(const Workbench& bench);

  /// Shows the places of the run that is shown; null or empty: none.
  void show(const HelpPlacesPtr& places);
  /// assist.go takes the hand to this one next.
  void choose(std::size_t place);

 signals:
  /// The view looks elsewhere.
  void cameraMoved();

 private:
  enum class Then { Show, Go };

  void followRun(const SnapshotPtr& snapshot);
  void offerInTime(const SessionSnapshot& snapshot);
  BackgroundTask::Work search(Then then);
  void find(Then then);
  void go();
  void startByHand();
  void takeHand();
  void look();
  void draw();
  QString hintText() const;
  void addCommands();

  const Workbench& bench_;
  HandHint hint_;
  BackgroundTask offers_;
  HelpPlacesPtr places_;    ///< null: none is shown
  std::size_t chosen_ = 0;  ///< of them
  bool taken_ = false;      ///< the hand was taken to the chosen one
  bool starting_ = false;   ///< a run by hand: the hand is taken to the chosen place once it has begun
  std::uint64_t run_ = 0;   ///< that is followed
  double nextOffer_ = 0.0;  ///< seconds of planning
};

}  // namespace glissade
