#include "widgets/help/manual_writer.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include "engine/base/file_save.h"
#include "widgets/help/manual_pages.h"

namespace glissade {
namespace {

struct ManualWriter {
  Q_DECLARE_TR_FUNCTIONS(ManualWriter)
};

QString linkTo(const ManualPage& page, const QString& relation, const QString& text) {
  return QStringLiteral("<a rel=\"%1\" href=\"%2.html\">%3</a>").arg(relation, page.name, text.toHtmlEscaped());
}

/// The list of all pages, with the sections of this one.
QString contentsOf(const std::vector<ManualPage>& pages, const ManualPage& here) {
  QString list;
  for (const ManualPage& page : pages) {
    const bool current = page.name == here.name;
    list += QStringLiteral("<li%1><a href=\"%2.html\">%3</a>")
                .arg(current ? QStringLiteral(" class=\"here\"") : QString(), page.name, page.title.toHtmlEscaped());
    QString sections;
    for (const MarkdownHeading& heading : page.content.headings) {
      if (!current || heading.level != 2) continue;
      sections += QStringLiteral("<li><a href=\"#%1\">%2</a></li>").arg(heading.anchor, heading.title.toHtmlEscaped());
    }
    if (!sections.isEmpty()) list += QStringLiteral("<ul>%1</ul>").arg(sections);
    list += QStringLiteral("</li>\n");
  }
  return QStringLiteral("<ul>\n%1</ul>\n").arg(list);
}

QString htmlOf(const std::vector<ManualPage>& pages, std::size_t index, const QString& language) {
  const ManualPage& page = pages[index];
  QString turns;
  if (index > 0)
    turns += linkTo(pages[index - 1], QStringLiteral("prev"), QStringLiteral("← ") + pages[index - 1].title);
  if (index + 1 < pages.size()) {
    turns += linkTo(pages[index + 1], QStringLiteral("next"), pages[index + 1].title + QStringLiteral(" →"));
  }
  return QStringLiteral(
             "<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\"/>\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
             "<title>%2 – %3</title>\n<link rel=\"stylesheet\" href=\"../manual.css\"/>\n</head>\n<body>\n"
             "<nav aria-label=\"%4\">\n<details open=\"open\"><summary>%4</summary>\n%5</details>\n</nav>\n<main>\n%6"
             "<p class=\"turns\">%7</p>\n</main>\n</body>\n</html>\n")
      .arg(language, page.title.toHtmlEscaped(), ManualWriter::tr("Glissade manual"), ManualWriter::tr("Contents"),
           contentsOf(pages, page), page.content.html, turns);
}

}  // namespace

Outcome writeManual(const ManualFacts& facts, const QString& folder) {
  const auto pages = manualPages(facts);
  if (!pages) return pages.error();
  const QString target = folder + QLatin1Char('/') + facts.language;
  if (!QDir().mkpath(target)) {
    return Diagnostic{ErrorKind::MalformedInput, target.toStdString(), "", GLISSADE_TEXT("the folder cannot be made"),
                      GLISSADE_TEXT("Choose another folder.")};
  }
  for (std::size_t i = 0; i < pages->size(); ++i) {
    const QString file = target + QLatin1Char('/') + (*pages)[i].name + QStringLiteral(".html");
    const SaveResult saved = saveFile(file.toStdString(), htmlOf(*pages, i, facts.language).toStdString());
    if (!saved) return saved.why;
  }
  QFile style(QStringLiteral(":/manual/manual.css"));
  style.open(QIODevice::ReadOnly);
  const SaveResult saved =
      saveFile((folder + QStringLiteral("/manual.css")).toStdString(), style.readAll().toStdString());
  return saved ? Outcome(Done{}) : Outcome(saved.why);
}

}  // namespace glissade
