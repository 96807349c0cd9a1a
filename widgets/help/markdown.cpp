#include "widgets/help/markdown.h"

#include <QRegularExpression>

namespace glissade {
namespace {

const QString kPicture = QStringLiteral(
    "<p class=\"picture\"><img src=\"../pictures/%1.png\" alt=\"%2\"/></p>\n"
    "<p class=\"caption\">%2</p>\n");

QString withoutTags(QString html) {
  static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
  html.remove(tag);
  return html.replace(QStringLiteral("&amp;"), QStringLiteral("&"));
}

class MarkdownRenderer {
 public:
  MarkdownRenderer(const QString& source, const MarkdownTerm& term)
      : lines_(source.split(QLatin1Char('\n'))), term_(term) {}

  MarkdownPage render() {
    while (at_ < lines_.size()) renderBlock();
    return std::move(page_);
  }

 private:
  const QString& line() const { return lines_[at_]; }
  bool more() const { return at_ < lines_.size() && !line().trimmed().isEmpty(); }
  void add(const QString& html) { page_.html += html + QLatin1Char('\n'); }

  void renderBlock() {
    static const QRegularExpression picture(QStringLiteral("^!\\[([^\\]]+)\\]\\(([^)]+)\\)$"));
    static const QRegularExpression term(QStringLiteral("^\\{([a-z]+):([^}]+)\\}$"));
    if (line().trimmed().isEmpty()) {
      ++at_;
    } else if (line().startsWith(QStringLiteral("```"))) {
      renderCode();
    } else if (line().startsWith(QLatin1Char('#'))) {
      renderHeading();
    } else if (line().startsWith(QLatin1Char('|'))) {
      renderTable();
    } else if (!itemText(line()).isNull()) {
      renderList();
    } else if (const auto match = picture.match(line()); match.hasMatch()) {
      page_.pictures << match.captured(2);
      page_.html += kPicture.arg(match.captured(2), inlineHtml(match.captured(1)));
      ++at_;
    } else if (const auto alone = term.match(line()); alone.hasMatch()) {
      add(term_(alone.captured(1), alone.captured(2)));
      ++at_;
    } else {
      renderParagraph();
    }
  }

  void renderCode() {
    QStringList code;
    for (++at_; at_ < lines_.size() && !line().startsWith(QStringLiteral("```")); ++at_) code << line();
    ++at_;
    add(QStringLiteral("<pre>%1</pre>").arg(code.join(QLatin1Char('\n')).toHtmlEscaped()));
  }

  void renderHeading() {
    static const QRegularExpression form(QStringLiteral("^(#+) (.*?)(?: \\{#([a-z0-9-]+)\\})?$"));
    const auto match = form.match(line());
    const int level = match.captured(1).size();
    page_.headings.push_back({level, match.captured(3), withoutTags(inlineHtml(match.captured(2)))});
    const QString title = page_.headings.back().title.toHtmlEscaped();
    const QString anchor =
        match.captured(3).isEmpty() ? QString() : QStringLiteral("<a name=\"%1\"></a>").arg(match.captured(3));
    add(QStringLiteral("<h%1>%2%3</h%1>").arg(level).arg(anchor, title));
    ++at_;
  }

  /// Renders a table. The first row is the header, the second one separates it from the others.
  void renderTable() {
    page_.html += QStringLiteral("<div class=\"wide\"><table>\n");
    for (int row = 0; more() && line().startsWith(QLatin1Char('|')); ++row, ++at_) {
      if (row == 1) continue;
      const QString cell = row == 0 ? QStringLiteral("<th>%1</th>") : QStringLiteral("<td>%1</td>");
      QString cells;
      for (const QString& text : line().mid(1, line().lastIndexOf(QLatin1Char('|')) - 1).split(QLatin1Char('|'))) {
        cells += cell.arg(inlineHtml(text.trimmed()));
      }
      add(QStringLiteral("<tr>%1</tr>").arg(cells));
    }
    add(QStringLiteral("</table></div>"));
  }

  /// The text after the mark of a list item; null if the line is none.
  static QString itemText(const QString& line) {
    static const QRegularExpression item(QStringLiteral("^(?:-|\\d+\\.) +(.*)$"));
    const auto match = item.match(line);
    return match.hasMatch() ? match.captured(1) : QString();
  }

  void renderList() {
    const QString kind = line().startsWith(QLatin1Char('-')) ? QStringLiteral("ul") : QStringLiteral("ol");
    add(QStringLiteral("<%1>").arg(kind));
    for (; more() && !itemText(line()).isNull(); ++at_) {
      add(QStringLiteral("<li>%1</li>").arg(inlineHtml(itemText(line()))));
    }
    add(QStringLiteral("</%1>").arg(kind));
  }

  void renderParagraph() {
    QStringList text;
    for (; more(); ++at_) text << line();
    add(QStringLiteral("<p>%1</p>").arg(inlineHtml(text.join(QLatin1Char(' ')))));
  }

  QString inlineHtml(const QString& text) {
    static const QRegularExpression mark(
        QStringLiteral("`(?<code>[^`]+)`|\\*\\*(?<strong>.+?)\\*\\*|\\*(?<em>.+?)\\*|"
                       "\\[(?<text>[^\\]]+)\\]\\((?<link>[^)]+)\\)|\\{(?<kind>[a-z]+):(?<argument>[^}]+)\\}"));
    QString html;
    int done = 0;
    for (auto marks = mark.globalMatch(text); marks.hasNext();) {
      const QRegularExpressionMatch match = marks.next();
      html += text.mid(done, match.capturedStart() - done).toHtmlEscaped() + markHtml(match);
      done = match.capturedEnd();
    }
    return html + text.mid(done).toHtmlEscaped();
  }

  QString markHtml(const QRegularExpressionMatch& match) {
    const auto has = [&match](const char* name) { return !match.captured(QLatin1String(name)).isEmpty(); };
    if (has("code")) return QStringLiteral("<code>%1</code>").arg(match.captured("code").toHtmlEscaped());
    if (has("strong")) return QStringLiteral("<b>%1</b>").arg(inlineHtml(match.captured("strong")));
    if (has("em")) return QStringLiteral("<i>%1</i>").arg(inlineHtml(match.captured("em")));
    if (has("kind")) return term_(match.captured("kind"), match.captured("argument"));
    page_.links << match.captured("link");
    return QStringLiteral("<a href=\"%1\">%2</a>")
        .arg(match.captured("link").toHtmlEscaped(), inlineHtml(match.captured("text")));
  }

  QStringList lines_;
  const MarkdownTerm& term_;
  int at_ = 0;
  MarkdownPage page_;
};

}  // namespace

MarkdownPage renderMarkdown(const QString& source, const MarkdownTerm& term) {
  return MarkdownRenderer(source, term).render();
}

}  // namespace glissade
