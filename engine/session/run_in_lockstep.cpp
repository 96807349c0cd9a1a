#include "engine/session/run_in_lockstep.h"

namespace glissade {

SnapshotPtr runInLockstep(LockstepSession& session, const StopToken& stop, std::uint64_t slice,
                          const std::function<void(const SessionSnapshot&)>& progressed) {
  session.post(command::Start{});
  session.advance(0);
  while (isRunning(*session.snapshot()) && !stop.stopRequested()) {
    session.advance(slice, stop);
    if (progressed) progressed(*session.snapshot());
  }
  if (isRunning(*session.snapshot())) {
    session.post(command::Stop{});
    session.advance(0);
  }
  return session.snapshot();
}

}  // namespace glissade
