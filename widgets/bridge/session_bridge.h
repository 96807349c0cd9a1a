#pragma once

#include <QMetaType>
#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <string>

#include "engine/operator/hand_inputs.h"
#include "engine/scenario/scenario_ptr.h"
#include "engine/session/session.h"

Q_DECLARE_METATYPE(glissade::SnapshotPtr)

namespace glissade {

/// Whose time the session lives in: ours, or one that advances only on request.
enum class SessionClock { RealTime, Lockstep };

/// A run to be shown again exactly as it was: headless runs are in lockstep and have no view.
struct FixedRun {
  ParameterValues parameters;
  std::string planner;
  std::uint64_t seed = 1;
  std::string deviceId;  ///< "none": nobody holds the device
};

/// The only class that crosses threads: owns the session, posts commands into it, and turns its
/// wake-ups into a signal on the GUI thread.
///
/// Where an exception leaves the making of a session (no memory, no thread), there is none: an earlier session would
/// prove paths in an arrangement that is not there any more. snapshot() is Failed and says why, and the next call
/// that needs a session tries to make it again with the same settings.
class SessionBridge final : public QObject {
  Q_OBJECT

 public:
  explicit SessionBridge(SessionClock clock, QObject* parent = nullptr);
  ~SessionBridge() override;

  /// A new session on this scenario; parameters and seed are the scenario's. The old session ends.
  void open(const ScenarioPtr& scenario);
  /// The same scenario with its bodies, its object or its ends elsewhere: ends a run; what has been set since it
  /// was opened stays. A path that was there is examined in the new arrangement; that of another object waits until
  /// that one moves again. The environment model is to be posted again.
  void rearrange(const ScenarioPtr& scenario);
  /// Gives the object into other hands (an id of the device registry). Ends a run; parameters, seed,
  /// planner, semantic edits, environment model and a path that was there stay.
  void setDevice(const std::string& deviceId);
  /// Takes a path from elsewhere in place of the run's: it is examined.
  void givePath(command::ExaminePath path);
  /// The path that is there is not kept for the session that comes next.
  void forgetPath() { forgets_ = true; }
  /// Who holds the object now; of a fixed run its own.
  const std::string& deviceId() const { return fixed_ ? fixedDeviceId_ : deviceId_; }

  /// Starts that run of the open scenario, in lockstep whatever the clock; on screen a timer lets its
  /// time go on. It holds until a scenario is opened or a device chosen.
  void startFixed(const FixedRun& run);

  void post(Command command);
  void setOperatorFrame(const OperatorFrame& frame);
  /// What the person at the window holds.
  const HandInputsPtr& hand() const { return hand_; }

  /// The one announced last; null while no scenario is open. Asking takes no news away from those who listen.
  const SnapshotPtr& snapshot() const { return announced_; }
  /// A run was started that snapshot() does not show yet.
  bool isStarting() const { return session_ && announced_ && announced_->run < startedRun_; }
  SessionClock clock() const { return clock_; }
  /// Lockstep only: lets the session do so many planner steps.
  void advance(std::uint64_t steps);

 signals:
  void snapshotChanged(const glissade::SnapshotPtr& snapshot);

 private:
  /// What a session begins with.
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
  SemanticEditsPtr edits_;                           ///< the scenario's, or posted since
  std::shared_ptr<const SceneKnowledge> knowledge_;  ///< likewise
  Settings settings_;                                ///< of the session that was made last or is to be made
  std::string deviceId_;
  OperatorFrame frame_;
  HandInputsPtr hand_;
  std::unique_ptr<Session> session_;
  SnapshotPtr announced_;
  std::uint64_t startedRun_ = 0;         ///< of session_: the number that the run posted last has at least
  LockstepSession* lockstep_ = nullptr;  ///< session_, where it is one
  /// By the object's id, what a new session is given; nothing once a run has begun.
  std::map<std::string, command::ExaminePath> kept_;
  bool forgets_ = false;  ///< the present path
  bool fixed_ = false;    ///< session_ is a FixedRun
  std::string fixedDeviceId_;
  QTimer pace_;  ///< of a fixed run on screen
};

}  // namespace glissade
