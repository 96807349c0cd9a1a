#pragma once

#include <QMetaType>
#include <QObject>
#include <memory>
#include <string>

#include "engine/operator/hand_inputs.h"
#include "engine/scenario/scenario.h"
#include "engine/session/session.h"

Q_DECLARE_METATYPE(glissade::SnapshotPtr)

namespace glissade {

using ScenarioPtr = std::shared_ptr<const LoadedScenario>;

/// Whose time the session lives in: ours, or one that goes on only when told to.
enum class SessionClock { RealTime, Lockstep };

/// The only class that crosses threads: owns the session, posts commands into it, and turns its
/// wake-ups into a signal on the GUI thread.
class SessionBridge final : public QObject {
  Q_OBJECT

 public:
  explicit SessionBridge(SessionClock clock, QObject* parent = nullptr);
  ~SessionBridge() override;

  /// A new session on this scenario; parameters and seed are the scenario's. The old session ends.
  void open(const ScenarioPtr& scenario);
  /// Gives the object into other hands (an id of the device registry). Ends a run; parameters, seed,
  /// planner, semantic edits and environment model stay as they were set.
  void setDevice(const std::string& deviceId);
  const std::string& deviceId() const { return deviceId_; }

  void post(Command command);
  void setOperatorFrame(const OperatorFrame& frame);
  /// What the person at the window holds.
  const HandInputsPtr& hand() const { return hand_; }

  /// Null while no scenario is open.
  SnapshotPtr snapshot() const;
  SessionClock clock() const { return clock_; }
  /// Lockstep only: lets the session do so many planner steps.
  void advance(std::uint64_t steps);

 signals:
  void snapshotChanged(const glissade::SnapshotPtr& snapshot);

 private:
  void restart(const ParameterValues& parameters, std::uint64_t seed, const std::string& planner);
  void emitSnapshot();

  SessionClock clock_;
  ScenarioPtr scenario_;
  SceneDescription scene_;  ///< the scenario's, with the edits and the knowledge posted since
  std::string deviceId_;
  OperatorFrame frame_;
  HandInputsPtr hand_;
  std::unique_ptr<Session> session_;
  LockstepSession* lockstep_ = nullptr;  ///< session_, where it is one
};

}  // namespace glissade
