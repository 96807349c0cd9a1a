// The names in the manual exist in the program, and the manual describes all parts of the program.
#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QSet>

#include "engine/base/parameters.h"
#include "tests/app/window_fixture.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/help/manual_pages.h"
#include "widgets/help/manual_terms.h"

namespace glissade::test {
namespace {

QString contentOfFile(const QString& name) {
  QFile file(name);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
  return QString::fromUtf8(file.readAll());
}

QStringList allMatches(const QString& text, const char* pattern) {
  QStringList found;
  for (auto matches = QRegularExpression(QLatin1String(pattern)).globalMatch(text); matches.hasNext();) {
    found << matches.next().captured(1);
  }
  return found;
}

/// The structure of a page, which is equal in every language: headings, lists, terms, pictures, links and code.
std::string structureOf(const QString& language, const QString& page) {
  QStringList structure;
  const QString source = manualSource(language, page);
  const MarkdownPage rendered = renderMarkdown(source, [&structure](const QString& kind, const QString& argument) {
    structure << QStringLiteral("{%1:%2}").arg(kind, argument);
    return QStringLiteral("x");
  });
  structure.sort();  // the order of sentences differs between languages
  for (const MarkdownHeading& heading : rendered.headings) {
    structure << QStringLiteral("%1 %2").arg(heading.level).arg(heading.anchor);
  }
  QStringList links = rendered.links;
  links.sort();
  structure << rendered.pictures << links;
  for (const char* tag : {"<li>", "<tr>", "<p>", "<pre>", "<td>"}) {
    structure << QStringLiteral("%1 %2").arg(QLatin1String(tag)).arg(rendered.html.count(QLatin1String(tag)));
  }
  return structure.join(QLatin1Char('\n')).toStdString();
}

/// "Context/text" of every message of the window.
QSet<QString> messagesOfTheWindow() {
  QSet<QString> messages;
  const QString translations = contentOfFile(kSource + QStringLiteral("/resources/i18n/glissade_fr.ts"));
  QString context;
  static const QRegularExpression entry(QStringLiteral("<name>([^<]*)</name>|<source>([^<]*)</source>"));
  for (auto matches = entry.globalMatch(translations); matches.hasNext();) {
    const auto match = matches.next();
    if (!match.captured(1).isEmpty()) {
      context = match.captured(1).remove(QStringLiteral("glissade::"));
    } else {
      QString text = match.captured(2);
      text.replace(QStringLiteral("&apos;"), QStringLiteral("'")).replace(QStringLiteral("&amp;"), QStringLiteral("&"));
      messages << context + QLatin1Char('/') + text;
    }
  }
  return messages;
}

TEST(Manual, FrenchPagesHaveTheStructureOfTheEnglishOnes) {
  for (const QString& page : manualPageNames()) {
    EXPECT_EQ(structureOf(QStringLiteral("fr"), page), structureOf(QStringLiteral("en"), page)) << page.toStdString();
  }
}

TEST(Manual, TextsOfTheWindowThatItNamesExist) {
  const QSet<QString> messages = messagesOfTheWindow();
  int seen = 0;
  for (const QString& page : manualPageNames()) {
    for (const QString& text : allMatches(manualSource(QStringLiteral("en"), page), "\\{ui:([^}]+)\\}")) {
      EXPECT_TRUE(messages.contains(text)) << page.toStdString() << ": " << text.toStdString();
      ++seen;
    }
  }
  EXPECT_GT(seen, 15);
}

TEST(Manual, ATermThatDoesNotExistIsAProblem) {
  ManualFacts facts;
  facts.actions.push_back({"run.start", "Start", "Run", "F5", "Plan"});
  ManualTerms terms(facts);
  EXPECT_EQ(terms.html("action", "run.start"), "<span class=\"ui\">Run &gt; Start</span> (<kbd>F5</kbd>)");
  EXPECT_TRUE(terms.problems().isEmpty());
  for (const char* kind : {"action", "keys", "panel", "parameter", "strategy", "operator", "table", "such"}) {
    terms.html(kind, "run.stop");
  }
  EXPECT_EQ(terms.problems().size(), 8);
}

TEST(Manual, EveryCommandOfTheCommandLineIsNamed) {
  QProcess process;
  process.start(QString::fromStdString(programDirectory() + "/glissade-cli"), {QStringLiteral("--help")});
  ASSERT_TRUE(process.waitForFinished(60000));
  QString help = QString::fromUtf8(process.readAllStandardOutput());
  help = help.mid(help.indexOf(QStringLiteral("Subcommands:")));
  const QStringList commands = allMatches(help, "\\n  ([a-z-]+) ");
  EXPECT_GT(commands.size(), 10);
  const QString page = manualSource(QStringLiteral("en"), QStringLiteral("command-line"));
  for (const QString& command : commands) EXPECT_TRUE(page.contains("| `" + command)) << command.toStdString();
}

class ManualOnDisk : public WindowTest, public testing::WithParamInterface<const char*> {
 protected:
  QString page(const QString& name) { return contentOfFile(folder.filePath(language() + "/" + name + ".html")); }
  QString language() const { return QLatin1String(GetParam()); }

  void expectTarget(const QString& from, const QString& link) {
    const QString file = link.section(QLatin1Char('#'), 0, 0);
    const QString anchor = link.section(QLatin1Char('#'), 1);
    const QString target = file.isEmpty() ? from : file.left(file.lastIndexOf(QLatin1Char('.')));
    ASSERT_TRUE(QFile::exists(folder.filePath(language() + "/" + target + ".html")) || file.endsWith(".css"))
        << from.toStdString() << ": " << link.toStdString();
    if (anchor.isEmpty()) return;
    EXPECT_TRUE(page(target).contains("<a name=\"" + anchor + "\">"))
        << from.toStdString() << ": " << link.toStdString();
  }
};

TEST_P(ManualOnDisk, LinksAndPicturesExistAndNothingIsMissing) {
  const WindowResult outcome = run(QString(),
                                   "action panel.semantics\naction help.panel\nexpect-manual panels#panel-semantics\n"
                                   "action help.manual\nshow-manual panels#panel-run\nexpect-manual panels#panel-run\n"
                                   "find-in-manual AP214\nexpect-manual formats\n",
                                   {"--language", language(), "--write-manual", folder.path()});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
  EXPECT_TRUE(QFile::exists(folder.filePath("manual.css")));
  for (const QString& name : manualPageNames()) {
    const QString html = page(name);
    EXPECT_FALSE(html.contains(QRegularExpression("\\{[a-z]+:"))) << name.toStdString();
    for (const QString& link : allMatches(html, "href=\"([^\"]+)\"")) expectTarget(name, link);
    for (const QString& picture : allMatches(html, "src=\"\\.\\./pictures/([^\"]+)\"")) {
      EXPECT_TRUE(QFile::exists(kSource + "/tests/golden/" + picture)) << picture.toStdString();
    }
  }
  const QString commands = page("commands");
  for (const ActionSpec& spec : windowActions()) {
    EXPECT_TRUE(commands.contains(QStringLiteral("<code>%1</code>").arg(QLatin1String(spec.id)))) << spec.id;
  }
  const QString parameters = page("parameters");
  for (const ParameterSpec& spec : parameterTable()) {
    const QString option = "--" + QString::fromStdString(std::string(spec.key)).replace('_', '-');
    EXPECT_EQ(option.toStdString(), spec.option) << "the page says how options are named";
    EXPECT_TRUE(parameters.contains("<code>" + QString::fromStdString(std::string(spec.key)) + "</code>")) << spec.key;
  }
  EXPECT_GE(allMatches(page("panels"), "<td>(<a href=\"panels\\.html#panel-)").size(), 12);
}

INSTANTIATE_TEST_SUITE_P(Languages, ManualOnDisk, testing::Values("en", "fr"));

}  // namespace
}  // namespace glissade::test
