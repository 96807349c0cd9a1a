#include "widgets/help/manual_pages.h"

#include <QFile>

#include "widgets/help/manual_terms.h"

/// Resources of a static library have to be initialised outside of any namespace.
static void takeManualResources() { Q_INIT_RESOURCE(manual); }

namespace glissade {

const QStringList& manualPageNames() {
  static const QStringList names{
      QStringLiteral("index"),        QStringLiteral("installation"), QStringLiteral("first-motion"),
      QStringLiteral("arranging"),    QStringLiteral("fits"),         QStringLiteral("planning"),
      QStringLiteral("results"),      QStringLiteral("certificate"),  QStringLiteral("sequences"),
      QStringLiteral("tutorial"),     QStringLiteral("places"),       QStringLiteral("stereo"),
      QStringLiteral("panels"),       QStringLiteral("parameters"),   QStringLiteral("commands"),
      QStringLiteral("command-line"), QStringLiteral("formats"),      QStringLiteral("troubleshooting")};
  return names;
}

QString manualSource(const QString& language, const QString& page) {
  takeManualResources();
  QFile file(QStringLiteral(":/manual/%1/%2.md").arg(language, page));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QString::fromUtf8(file.readAll());
}

Result<std::vector<ManualPage>> manualPages(const ManualFacts& facts) {
  std::vector<ManualPage> pages;
  for (const QString& name : manualPageNames()) {
    const std::string file = (facts.language + QLatin1Char('/') + name + QStringLiteral(".md")).toStdString();
    const QString source = manualSource(facts.language, name);
    ManualTerms terms(facts);
    MarkdownPage content = renderMarkdown(
        source, [&terms](const QString& kind, const QString& argument) { return terms.html(kind, argument); });
    if (content.headings.empty()) {
      return Diagnostic{ErrorKind::Internal, file, "", GLISSADE_TEXT("the page of the manual has no heading"),
                        GLISSADE_TEXT("Write it.")};
    }
    if (!terms.problems().isEmpty()) {
      return Diagnostic{
          ErrorKind::Internal,
          file,
          "",
          {GLISSADE_TEXT("the manual names what does not exist: %1"), {terms.problems().join(' ').toStdString()}},
          GLISSADE_TEXT("Correct the page.")};
    }
    const QString title = content.headings.front().title;
    pages.push_back({name, title, std::move(content)});
  }
  return pages;
}

}  // namespace glissade
