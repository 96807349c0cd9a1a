#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include <QObject>

namespace glissade {

/// Returns a function for any thread that makes the call on the receiver's thread, once for all requests until then.
/// Copies request the same call. Precondition: nobody requests a call after the receiver was destroyed. A call that
/// waits then is dropped.
inline std::function<void()> queuedOnce(QObject* receiver, std::function<void()> call) {
  const auto pending = std::make_shared<std::atomic<bool>>(false);
  return [receiver, pending, call = std::move(call)] {
    if (pending->exchange(true)) return;
    const auto once = [pending, call] {
      *pending = false;
      call();
    };
    QMetaObject::invokeMethod(receiver, once, Qt::QueuedConnection);
  };
}

}  // namespace glissade
