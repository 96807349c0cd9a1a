#include "widgets/controls/message_log.h"

namespace glissade {
namespace {

constexpr std::size_t kMostEntries = 2000;

}  // namespace

void MessageLog::add(LogLevel level, const QString& text) {
  const QString line = text.simplified();
  if (line.isEmpty()) return;
  if (!entries_.empty() && entries_.back().level == level && entries_.back().text == line) return;
  entries_.push_back({QDateTime::currentDateTime(), level, line});
  if (entries_.size() > kMostEntries) entries_.pop_front();
  emit changed();
}

QString levelText(LogLevel level) {
  switch (level) {
    case LogLevel::Information: return MessageLog::tr("Information");
    case LogLevel::Warning: return MessageLog::tr("Warning");
    case LogLevel::Error: break;
  }
  return MessageLog::tr("Error");
}

}  // namespace glissade
