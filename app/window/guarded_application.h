#pragma once

#include <QApplication>

#include <functional>
#include <utility>

#include "engine/base/diagnostic.h"

namespace glissade {

/// The application whose event handlers may throw: this is the one place of the GUI thread where an exception becomes
/// a diagnostic. Qt itself would end the program.
class GuardedApplication final : public QApplication {
 public:
  using FailureHandler = std::function<void(const Diagnostic&)>;

  using QApplication::QApplication;

  /// Receives exceptions that leave an event handler. While it is at work (a dialog handles events, too) further
  /// ones go to standard error. None: exceptions leave notify().
  void setFailureHandler(FailureHandler handler) { handler_ = std::move(handler); }

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  void report(const Diagnostic& why);

  FailureHandler handler_;
  bool reporting_ = false;
};

}  // namespace glissade
