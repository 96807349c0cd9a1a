#pragma once

#include <QComboBox>

#include <vector>

namespace glissade {

/// A list with the entries for daily use at first sight, and a row "Research" that adds the others.
class ResearchBox final : public QComboBox {
  Q_OBJECT

 public:
  struct Entry {
    QString id;
    QString label;
    QString tip;
    bool research = false;
  };

  ResearchBox(std::vector<Entry> entries, QWidget* parent);

  QString chosen() const { return currentData().toString(); }
  /// Shows this entry, and all entries of research if it is one of them.
  void setChosen(const QString& id);
  /// Makes an entry grey, with the reason in its row; empty: it can be chosen.
  void setReason(const QString& id, const QString& reason);
  void showPopup() override;

 signals:
  /// A person chose another entry.
  void entryChosen(const QString& id);
  void popupDue();

 private:
  void add(const Entry& entry);
  void listResearch();
  bool listsResearch() const { return count() > researchRow_ + 1; }

  std::vector<Entry> entries_;
  int researchRow_ = 0;
  QString shown_;  ///< the entry of the last setChosen()
};

}  // namespace glissade
