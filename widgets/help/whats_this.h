#pragma once

#include <QMainWindow>
#include <QStringList>

namespace glissade {

/// Gives every panel and every column of a table the text that "What's this?" (Shift+F1) shows. A widget without a text
/// shows that of its panel. Precondition: all panels exist.
void explainWindow(QMainWindow& window);

/// For tests: the interactive widgets of the window that have no text and lie in no widget with one.
QStringList unexplainedWidgets(const QMainWindow& window);

}  // namespace glissade
