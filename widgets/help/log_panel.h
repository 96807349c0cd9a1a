#pragma once

#include <QComboBox>
#include <QTreeWidget>

#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/message_log.h"

namespace glissade {

/// The messages of the window from a level on; the newest is the last.
class LogPanel final : public QWidget {
  Q_OBJECT

 public:
  LogPanel(const MessageLog& log, const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// The messages that are shown, one line each.
  QStringList lines() const;
  void setLevel(LogLevel least);

 private:
  void show();

  const MessageLog& log_;
  QComboBox* level_;
  QTreeWidget* table_;
};

}  // namespace glissade
