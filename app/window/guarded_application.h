#pragma once

#include <QApplication>

#include <functional>
#include <utility>

#include "engine/base/diagnostic.h"

namespace glissade {

/// The application. Its event handlers may throw: here the GUI thread turns exceptions into diagnostics. Qt would end
/// the program.
class GuardedApplication final : public QApplication {
 public:
  using FailureHandler = std::function<void(const Diagnostic&)>;

  using QApplication::QApplication;

  /// Sets the handler of exceptions that leave an event handler. While it runs (a dialog handles events too), further
  /// exceptions go to standard error. Without a handler, exceptions leave notify().
  void setFailureHandler(FailureHandler handler) { handler_ = std::move(handler); }

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  void report(const Diagnostic& why);

  FailureHandler handler_;
  bool reporting_ = false;
};

}  // namespace glissade
