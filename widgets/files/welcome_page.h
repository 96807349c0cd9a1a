#pragma once

#include <QBoxLayout>
#include <QLabel>
#include <QScrollArea>

#include <vector>

#include "widgets/controls/action_catalogue.h"
#include "widgets/files/card_grid.h"

namespace glissade {

/// The page that the window shows while no scenario is open: first actions, recent files, and samples.
class WelcomePage final : public QScrollArea {
  Q_OBJECT

 public:
  WelcomePage(const ActionCatalogue& actions, QWidget* parent);

  /// Sets the recent files; without any the section is hidden.
  void setRecent(const std::vector<WelcomeEntry>& entries);
  void setSamples(const std::vector<WelcomeEntry>& entries);
  /// Says in place of the samples why there are none.
  void setWhyNoSamples(const QString& text);

 signals:
  void chosen(const QString& file);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Section {
    QLabel* title;
    CardGrid* grid;
    QWidget* gap;  ///< below the cards
  };

  QLayout* makeHead(const ActionCatalogue& actions);
  Section makeSection(const QString& title, QLayout& column);
  void fill(const Section& section, const std::vector<WelcomeEntry>& entries);

  /// Arranges the buttons in a row, or below each other if the page is too narrow.
  void arrangeButtons();
  /// Makes each grid as high as all of its cards at the page's width.
  void arrangeGrids();

  QWidget* content_;
  QBoxLayout* buttons_;
  Section recent_;
  Section samples_;
  QLabel* whyNoSamples_;
};

}  // namespace glissade
