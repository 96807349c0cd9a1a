#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>

#include <deque>

namespace glissade {

enum class LogLevel { Information, Warning, Error };

struct LogEntry {
  QDateTime time;
  LogLevel level = LogLevel::Information;
  QString text;  ///< one line
};

/// The last 2,000 messages that the window has shown since it was opened. Used on the GUI thread only.
class MessageLog final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Adds a message. Line breaks become spaces; a message that repeats the one before is not added.
  void add(LogLevel level, const QString& text);
  const std::deque<LogEntry>& entries() const { return entries_; }

 signals:
  void changed();

 private:
  std::deque<LogEntry> entries_;
};

/// Name of the level in the user's language, such as "Error".
QString levelText(LogLevel level);

}  // namespace glissade
