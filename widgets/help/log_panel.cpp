#include "widgets/help/log_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <QVBoxLayout>

namespace glissade {
namespace {

enum LogColumn { LogTime, LogLevelColumn, LogText, LogColumnCount };

}  // namespace

LogPanel::LogPanel(const MessageLog& log, const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent), log_(log), level_(new QComboBox(this)), table_(new QTreeWidget(this)) {
  level_->addItem(tr("All messages"), static_cast<int>(LogLevel::Information));
  level_->addItem(tr("Warnings and errors"), static_cast<int>(LogLevel::Warning));
  level_->addItem(tr("Errors"), static_cast<int>(LogLevel::Error));
  level_->setAccessibleName(tr("Level of the messages that are shown"));
  level_->setToolTip(level_->accessibleName());
  table_->setColumnCount(LogColumnCount);
  table_->setHeaderLabels({tr("Time"), tr("Level"), tr("Message")});
  table_->setRootIsDecorated(false);
  table_->setAlternatingRowColors(true);
  table_->setAccessibleName(tr("Messages"));
  table_->setObjectName(QStringLiteral("log-messages"));
  table_->header()->setSectionResizeMode(LogTime, QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(LogLevelColumn, QHeaderView::ResizeToContents);
  QLayout* row = makeActionFlow(actions, {"log.copy"}, this);
  row->addWidget(level_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row);
  column->addWidget(table_, 1);
  connect(level_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LogPanel::show);
  connect(&log, &MessageLog::changed, this, &LogPanel::show);
  show();
}

void LogPanel::setLevel(LogLevel least) { level_->setCurrentIndex(level_->findData(static_cast<int>(least))); }

void LogPanel::show() {
  const auto least = static_cast<LogLevel>(level_->currentData().toInt());
  table_->clear();
  for (const LogEntry& entry : log_.entries()) {
    if (entry.level < least) continue;
    auto* item = new QTreeWidgetItem(table_);
    item->setText(LogTime, entry.time.time().toString(QStringLiteral("HH:mm:ss")));
    item->setText(LogLevelColumn, levelText(entry.level));
    item->setText(LogText, entry.text);
    item->setToolTip(LogText, entry.text);
  }
  table_->scrollToBottom();
}

QStringList LogPanel::lines() const {
  QStringList lines;
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    const QTreeWidgetItem& item = *table_->topLevelItem(i);
    lines << item.text(LogLevelColumn) + QStringLiteral(": ") + item.text(LogText);
  }
  return lines;
}

}  // namespace glissade
