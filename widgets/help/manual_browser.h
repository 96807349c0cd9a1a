#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTextBrowser>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include "widgets/help/manual_pages.h"

namespace glissade {

/// Shows pages of the manual. Their pictures are FOLDER/pictures/NAME.png, and never wider than the view.
class ManualView final : public QTextBrowser {
  Q_OBJECT

 public:
  ManualView(const QString& folder, QWidget* parent);

  void setPages(std::vector<ManualPage> pages);
  const std::vector<ManualPage>& pages() const { return pages_; }
  /// Index of the page. Precondition: there are pages.
  std::size_t currentPage() const;
  void openPage(const QString& page, const QString& anchor);

  QVariant loadResource(int type, const QUrl& url) override;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QVariant picture(const QString& name) const;
  void applyStyle();
  void layOutAgain();

  QString folder_;
  std::vector<ManualPage> pages_;
  QTimer afterResize_;
  int laidOutWidth_ = 0;
};

/// The manual in a window, with contents, pages, and a search through all of them.
class ManualBrowser final : public QDialog {
  Q_OBJECT

 public:
  /// `folder`: the pictures, and the pages on the disk; may be absent.
  ManualBrowser(const QString& folder, QWidget* parent);

  void setManual(const QString& language, std::vector<ManualPage> pages);
  void openPage(const QString& page, const QString& anchor = {}) { view_->openPage(page, anchor); }
  /// The place that is shown, such as "panels#panel-run"; without "#" at the beginning of a page.
  QString place() const;
  /// Goes to the next occurrence of the text, or to the one before, through all pages. False if there is none.
  bool find(const QString& text, bool forward);

  QSize sizeHint() const override { return {1120, 760}; }

 private:
  QToolButton* addButton(QLayout* row, const QString& text, const QString& tip, const QKeySequence& keys);
  void connectView();
  void showPlaceInContents();
  void search(bool forward);
  QString fileOnDisk() const;

  QString folder_;
  QString language_;
  QTreeWidget* contents_;
  ManualView* view_;
  QToolButton* back_;
  QToolButton* forward_;
  QToolButton* outside_;
  QLineEdit* wanted_;
};

}  // namespace glissade
