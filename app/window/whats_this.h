#pragma once

#include <QMainWindow>
#include <QStringList>

namespace glissade {

/// Gives every panel and every column of a table the text that "What's this?" (Shift+F1) shows. A widget without a text
/// of its own has that of the panel it lies in. To be called when all of them are there.
void explainWindow(QMainWindow& window);

/// The interactive widgets of the window that neither have a text nor lie in a widget that has one. For tests.
QStringList unexplainedWidgets(const QMainWindow& window);

}  // namespace glissade
