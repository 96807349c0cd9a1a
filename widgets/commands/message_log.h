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

/// What the window has told the user since it was opened: the last 2,000 messages. Used on the GUI thread only.
class MessageLog final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Line breaks become spaces; the same text again, right after itself, is not added.
  void add(LogLevel level, const QString& text);
  const std::deque<LogEntry>& entries() const { return entries_; }

 signals:
  void changed();

 private:
  std::deque<LogEntry> entries_;
};

/// "Error", in the user's language.
QString levelText(LogLevel level);

}  // namespace glissade
