#pragma once

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

namespace glissade {

struct MarkdownHeading {
  int level = 1;
  QString anchor;  ///< empty if the source gives none
  QString title;   ///< plain text
};

struct MarkdownPage {
  QString html;  ///< content of the body
  std::vector<MarkdownHeading> headings;
  QStringList pictures;  ///< names, without folder and extension
  QStringList links;     ///< as the source writes them
};

/// Makes the HTML of a term `{kind:argument}`.
using MarkdownTerm = std::function<QString(const QString& kind, const QString& argument)>;

/// The part of Markdown that the manual uses, as HTML: headings `# Title {#anchor}` of three levels, paragraphs, lists
/// of one level, tables, code, **strong**, *emphasis*, [links](page.html), pictures `![text](name)` that stand alone,
/// and terms `{kind:argument}`, which `term` makes HTML of. Pictures are `../pictures/name.png`.
MarkdownPage renderMarkdown(const QString& source, const MarkdownTerm& term);

}  // namespace glissade
