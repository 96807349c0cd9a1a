#pragma once

#include <QString>

#include <vector>

#include "engine/base/result.h"
#include "widgets/help/manual_facts.h"
#include "widgets/help/markdown.h"

namespace glissade {

struct ManualPage {
  QString name;  ///< "fits": fits.html
  QString title;
  MarkdownPage content;
};

/// Names of the pages, in the order of the contents.
const QStringList& manualPageNames();
/// The Markdown source of a page; null if the language has no such page.
QString manualSource(const QString& language, const QString& page);

/// All pages in the language of the facts. An error names the page and the unknown term or link in it.
Result<std::vector<ManualPage>> manualPages(const ManualFacts& facts);

}  // namespace glissade
