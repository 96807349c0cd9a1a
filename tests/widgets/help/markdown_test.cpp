#include "widgets/help/markdown.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

MarkdownPage rendered(const char* source) {
  return renderMarkdown(QString::fromUtf8(source), [](const QString& kind, const QString& argument) {
    return QStringLiteral("[%1 %2]").arg(kind, argument);
  });
}

TEST(Markdown, HeadingsHaveLevelAnchorAndTitle) {
  const MarkdownPage page = rendered("# A & *b*\n\n## {panel:run} {#panel-run}\n");
  ASSERT_EQ(page.headings.size(), 2U);
  EXPECT_EQ(page.headings[0].title, "A & b");
  EXPECT_TRUE(page.headings[0].anchor.isEmpty());
  EXPECT_EQ(page.headings[1].level, 2);
  EXPECT_EQ(page.headings[1].anchor, "panel-run");
  EXPECT_TRUE(page.html.contains("<h2><a name=\"panel-run\"></a>[panel run]</h2>"));
}

TEST(Markdown, ParagraphsListsTablesAndCode) {
  EXPECT_EQ(rendered("one\ntwo\n\nthree\n").html, "<p>one two</p>\n<p>three</p>\n");
  EXPECT_EQ(rendered("- a\n- b\n").html, "<ul>\n<li>a</li>\n<li>b</li>\n</ul>\n");
  EXPECT_EQ(rendered("1. a\n2. b\n").html, "<ol>\n<li>a</li>\n<li>b</li>\n</ol>\n");
  EXPECT_EQ(rendered("```\na <b>\n\n*c*\n```\n").html, "<pre>a &lt;b&gt;\n\n*c*</pre>\n");
  EXPECT_EQ(rendered("| h |\n| --- |\n| `c` |\n").html,
            "<div class=\"wide\"><table>\n<tr><th>h</th></tr>\n<tr><td><code>c</code></td></tr>\n</table></div>\n");
}

TEST(Markdown, TextIsEscapedAndMarked) {
  EXPECT_EQ(rendered("a < b, **c** and *d* `e*f*`\n").html,
            "<p>a &lt; b, <b>c</b> and <i>d</i> <code>e*f*</code></p>\n");
  const MarkdownPage page = rendered("see [the *page*](fits.html#find), {action:run.start}\n");
  EXPECT_EQ(page.html, "<p>see <a href=\"fits.html#find\">the <i>page</i></a>, [action run.start]</p>\n");
  EXPECT_EQ(page.links, QStringList{"fits.html#find"});
}

TEST(Markdown, APictureHasItsCaption) {
  const MarkdownPage page = rendered("![A window](welcome)\n");
  EXPECT_EQ(page.pictures, QStringList{"welcome"});
  EXPECT_TRUE(page.html.contains("<img src=\"../pictures/welcome.png\" alt=\"A window\"/>"));
}

}  // namespace
}  // namespace glissade
