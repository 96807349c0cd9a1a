// Calls that take long: without the interpreter's lock, and ended by Ctrl+C.
#pragma once

#include <glissade/stop_token.h>
#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <utility>

namespace glissade::python {

namespace py = pybind11;

/// One call of a long function with the callbacks that it makes. The function works on a thread of its own, because
/// only Python's main thread learns of Ctrl+C.
class LongCall {
 public:
  /// Ends the call.
  StopToken stop() const { return source_.token(); }

  /// The result of `work`. After Ctrl+C, or after an exception of a callback, the work is stopped and the exception is
  /// thrown.
  template <class Work>
  auto result(const Work& work) {
    const py::gil_scoped_release withoutLock;
    auto future = std::async(std::launch::async, work);
    constexpr std::chrono::milliseconds kPatience{50};
    while (future.wait_for(kPatience) != std::future_status::ready) {
      const py::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0) noteFailure();
    }
    auto result = future.get();
    if (failure_) std::rethrow_exception(failure_);
    return result;
  }

  /// Calls Python's code from the working thread. After an exception the whole call is stopped, and `otherwise` is
  /// returned.
  template <class Callback, class Value>
  Value callBack(const Callback& callback, Value otherwise) {
    const py::gil_scoped_acquire lock;
    if (failure_) return otherwise;
    try {
      return callback();
    } catch (...) {
      failure_ = std::current_exception();
      source_.requestStop();
      return otherwise;
    }
  }

 private:
  /// Takes the exception that Python has set.
  void noteFailure() {
    try {
      throw py::error_already_set();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
    source_.requestStop();
  }

  StopSource source_;
  std::exception_ptr failure_;  ///< used with the interpreter's lock only
};

}  // namespace glissade::python
