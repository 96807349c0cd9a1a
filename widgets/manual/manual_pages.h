#pragma once

#include <QString>

#include <vector>

#include "engine/base/result.h"
#include "widgets/manual/manual_facts.h"
#include "widgets/manual/markdown.h"

namespace glissade {

struct ManualPage {
  QString name;  ///< "fits": fits.html
  QString title;
  MarkdownPage content;
};

/// Names of the pages, in the order of the contents.
const QStringList& manualPageNames();
/// The Markdown that a page is made of; null where the language has no such page.
QString manualSource(const QString& language, const QString& page);

/// All pages in the language of the facts. An error names the page and what it names that does not exist.
Result<std::vector<ManualPage>> manualPages(const ManualFacts& facts);

}  // namespace glissade
