#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "engine/collision/collision_query.h"
#include "engine/operator/hand_guide.h"
#include "widgets/run/difficulty_panel.h"
#include "widgets/run/hand_lead.h"
#include "widgets/run/stopped_object.h"
#include "widgets/workbench/scene_hint.h"
#include "widgets/workbench/workbench.h"

namespace glissade {

/// The text over the scene for a person who steers: what the search needs from the hand, and the keys during a run by
/// hand.
class HandHint final : public QObject {
  Q_OBJECT

 public:
  explicit HandHint(const Workbench& bench);

  /// Shows a request to the person, and the next motion of the hand; empty: none.
  void ask(const QString& text);
  void lead(const std::vector<KeyToHold>& keys);
  /// Says that this body stops the object, and which moves are free; empty: nothing stops it.
  void stop(const QString& body, const std::vector<const SteeringKey*>& free);
  /// See SceneHint.
  double coveredShare() const { return hint_->coveredShare(); }

 private:
  void write();
  bool isByHand() const;
  bool isByKeys() const;
  QString state() const;
  QString toGoal() const;
  QString keys() const;

  const Workbench& bench_;
  SceneHint* hint_;
  QString asked_;
  QString lead_;
  QString stopped_;
  QString shown_;
};

/// Offers the places where a search is stuck, and takes the hand and the view there. It does so in a run that uses the
/// hand, or in a new run if the last one found no path or had no hand. On screen, a run by hand that does not end shows
/// the offers unasked.
class AssistController final : public QObject {
  Q_OBJECT

 public:
  explicit AssistController(const Workbench& bench);

  /// Shows the places of this run; null or empty: none.
  void show(const HelpPlacesPtr& places);
  /// Chooses the place to which assist.go takes the hand next.
  void choose(std::size_t place);

 signals:
  /// The camera was moved.
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
  void lead();
  void noticeStop();
  CollisionQuery& object();
  QString hintText() const;
  void addCommands();

  const Workbench& bench_;
  HandHint hint_;
  BackgroundTask offers_;
  std::weak_ptr<char> search_;              ///< lives as long as a search that was asked for
  HelpPlacesPtr places_;                    ///< null: none is shown
  std::size_t chosen_ = 0;                  ///< index in places_
  bool taken_ = false;                      ///< the hand was taken to the chosen place
  std::optional<HandGuide> guide_;          ///< along the passage of the chosen place; nothing until a hand is led
  std::unique_ptr<CollisionQuery> sight_;   ///< of pointWorld(); null until a hand is led
  std::unique_ptr<CollisionQuery> object_;  ///< null until a hand is led
  bool starting_ = false;   ///< a run by hand starts; the hand is taken to the chosen place once it runs
  std::uint64_t run_ = 0;   ///< the run that is followed
  bool running_ = false;    ///< a run is under way
  double nextOffer_ = 0.0;  ///< seconds of planning
  StoppedObject stopped_;
  QElapsedTimer clock_;
  QTimer lead_;  ///< leads the hand at the next timeout, so that people can read the hint
};

}  // namespace glissade
