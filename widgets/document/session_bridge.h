#pragma once

#include <QMetaType>
#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <string>

#include "engine/files/scenario_ptr.h"
#include "engine/operator/hand_inputs.h"
#include "engine/session/session.h"

Q_DECLARE_METATYPE(glissade::SnapshotPtr)

namespace glissade {

/// The clock of the session: real time, or a time that advances only on request.
enum class SessionClock { RealTime, Lockstep };

/// A recorded run to be shown again exactly: headless runs are in lockstep and have no view.
struct FixedRun {
  ParameterValues parameters;
  std::string planner;
  std::uint64_t seed = 1;
  std::string deviceId;  ///< "none": the device has no operator
};

/// Owns the session, posts commands into it, and turns its wake-ups into a signal on the GUI thread.
///
/// If an exception prevents a new session (no memory, no thread), there is no session: an earlier one would prove paths
/// in an arrangement that does not exist any more. snapshot() is Failed and gives the reason, and the next call that
/// needs a session tries to make it again with the same settings.
class SessionBridge final : public QObject {
  Q_OBJECT

 public:
  explicit SessionBridge(SessionClock clock, QObject* parent = nullptr);
  ~SessionBridge() override;

  /// Begins a new session on this scenario; parameters and seed are the scenario's. The old session ends.
  void open(const ScenarioPtr& scenario);
  /// Takes the same scenario with other poses of bodies, another object or other ends. A run ends; settings since
  /// open() stay. The path is examined in the new arrangement; the path of another object waits until that object moves
  /// again. The environment model has to be posted again. Where only names differ, the run and its result stay.
  void rearrange(const ScenarioPtr& scenario);
  /// Selects the device that moves the object (an id of the device registry). A run ends; parameters, seed, planner,
  /// semantic edits, environment model and path stay.
  void setDevice(const std::string& deviceId);
  /// Replaces the run's path by a path from elsewhere, which is examined.
  void givePath(command::ExaminePath path);
  /// The next session does not take over the present path.
  void forgetPath() { forgets_ = true; }
  /// Id of the device that moves the object now; a fixed run has its own.
  const std::string& deviceId() const { return fixed_ ? fixedDeviceId_ : deviceId_; }

  /// Starts this run of the open scenario in lockstep, whatever the clock; on screen a timer advances its time. The run
  /// lasts until another session begins.
  void startFixed(const FixedRun& run);

  void post(Command command);
  void setOperatorFrame(const OperatorFrame& frame);
  const OperatorFrame& operatorFrame() const { return frame_; }
  /// The devices that the person at the window holds.
  const HandInputsPtr& hand() const { return hand_; }

  /// The snapshot that was announced last; null while no scenario is open. Calling this takes no news away from
  /// observers.
  const SnapshotPtr& snapshot() const { return announced_; }
  /// Whether a run was started that snapshot() does not show yet.
  bool isStarting() const { return session_ && announced_ && announced_->run < startedRun_; }
  SessionClock clock() const { return clock_; }
  /// Lets the session do this many planner steps; in lockstep only.
  void advance(std::uint64_t steps);

 signals:
  void snapshotChanged(const glissade::SnapshotPtr& snapshot);

 private:
  /// The settings that a session begins with.
  struct Settings {
    ParameterValues parameters{1.0};
    std::uint64_t seed = 1;
    std::string planner;
  };

  void restart();
  template <class Prepare>
  void beginAnew(const Prepare& prepare);
  void fail(const Diagnostic& why);
  void takeSettings();
  void keepPath(const std::string& objectId);
  void end();
  void begin(SessionConfig config, SessionClock clock);
  std::unique_ptr<OperatorDevice> makeDevice(const std::string& id, std::uint64_t seed);
  void emitSnapshot();

  SessionClock clock_;
  ScenarioPtr scenario_;
  SemanticEditsPtr edits_;                           ///< the scenario's edits, or edits posted since
  std::shared_ptr<const SceneKnowledge> knowledge_;  ///< settings of the session that was made last or is to be made
  Settings settings_;                                ///< of the session that was made last or is to be made
  std::string deviceId_;
  OperatorFrame frame_;
  HandInputsPtr hand_;
  std::unique_ptr<Session> session_;
  SnapshotPtr announced_;
  std::uint64_t startedRun_ = 0;         ///< the run of session_ that was posted last has at least this number
  LockstepSession* lockstep_ = nullptr;  ///< session_, if it is in lockstep
  /// Path that a new session is given, by the object's id; no path once a run has begun.
  std::map<std::string, command::ExaminePath> kept_;
  bool forgets_ = false;  ///< the next session does not take over the present path
  bool fixed_ = false;    ///< session_ is a FixedRun
  std::string fixedDeviceId_;
  QTimer pace_;  ///< advances a fixed run on screen
};

}  // namespace glissade
