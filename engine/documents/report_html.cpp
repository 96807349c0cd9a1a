#include "engine/documents/report_html.h"

#include <cstring>
#include <utility>

#include "engine/base/file.h"
#include "engine/documents/xml_text.h"

namespace glissade {
namespace {

constexpr std::size_t kMostPictureBytes = 32U << 20;

constexpr const char* kStyle = R"(
:root { --ink: #1d2329; --soft: #5b646e; --line: #c9d0d8; --ground: #ffffff; --band: #f4f6f9; --link: #0072b2; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e3e6ea; --soft: #9aa2ac; --line: #414852; --ground: #1b1d21; --band: #24272c; --link: #56b4e9; }
}
@media print {
  :root { --ink: #000000; --soft: #444444; --line: #bbbbbb; --ground: #ffffff; --band: #f4f6f9; }
  figure, tr { break-inside: avoid; }
  h2 { break-after: avoid; }
  .page { break-before: page; }
  body { max-width: none; padding: 0; font-size: 10pt; }
}
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 68rem; background: var(--ground); color: var(--ink);
  font: 15px/1.5 "DejaVu Sans", "Segoe UI", system-ui, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 1rem; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 0.8rem; padding-bottom: 0.3rem; border-bottom: 1px solid var(--line); }
p { max-width: 50rem; }
.wide { overflow-x: auto; }
.wide + .wide { margin-top: 1.2rem; }
table { border-collapse: collapse; font-size: 0.86rem; font-variant-numeric: tabular-nums; }
caption { caption-side: bottom; text-align: left; color: var(--soft); padding-top: 0.5rem; }
th, td { padding: 0.3rem 0.7rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
th { background: var(--band); font-weight: 600; vertical-align: bottom; }
.number { text-align: right; white-space: nowrap; }
th.number { white-space: normal; }
td:first-child { white-space: nowrap; }
td.prose:first-child { white-space: normal; min-width: 16rem; }
figure { margin: 1.5rem 0; }
figure svg, figure img { max-width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: 0.86rem; max-width: 50rem; }
)";

/// CSS class of a cell.
std::string classOf(const ReportColumn& column) {
  if (column.kind == ReportColumn::Kind::Number) return " class=\"number\"";
  return column.kind == ReportColumn::Kind::Prose ? " class=\"prose\"" : "";
}

/// Colours of drawings, and the colours of the style sheet in their place.
constexpr std::pair<const char*, const char*> kColoursOfPage[] = {{"\"#1d2329\"", "\"var(--ink, #1d2329)\""},
                                                                  {"\"#ffffff\"", "\"var(--ground, #ffffff)\""},
                                                                  {"\"#c9d0d8\"", "\"var(--line, #c9d0d8)\""},
                                                                  {"\"#eef3f8\"", "\"var(--band, #eef3f8)\""}};

/// The drawing in the colours of the style sheet, which has light and dark ones.
std::string inColoursOfPage(std::string svg) {
  for (const auto& [drawn, shown] : kColoursOfPage) {
    for (std::size_t at = svg.find(drawn); at != std::string::npos; at = svg.find(drawn, at + std::strlen(shown))) {
      svg.replace(at, std::strlen(drawn), shown);
    }
  }
  return svg;
}

bool hasTitles(const ReportTable& table) {
  for (const ReportColumn& column : table.columns) {
    if (!column.title.empty()) return true;
  }
  return false;
}

class Page {
 public:
  std::optional<Diagnostic> error;
  std::string out;

  void operator()(const ReportHeading& heading) {
    const std::string tag = "h" + std::to_string(heading.level);
    out += "<" + tag + (heading.newPage ? " class=\"page\">" : ">") + escaped(heading.text) + "</" + tag + ">\n";
  }

  void operator()(const ReportText& text) { out += "<p>" + escaped(text.text) + "</p>\n"; }

  void operator()(const ReportTable& table) {
    out += "<div class=\"wide\"><table>\n";
    if (!table.caption.empty()) out += "<caption>" + escaped(table.caption) + "</caption>\n";
    if (hasTitles(table)) addTitles(table);
    out += "<tbody>\n";
    for (const auto& row : table.rows) {
      out += "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i) {
        out += "<td" + classOf(table.columns[i]) + ">" + escaped(row[i]) + "</td>";
      }
      out += "</tr>\n";
    }
    out += "</tbody>\n</table></div>\n";
  }

  void operator()(const ReportDrawing& drawing) {
    out += "<figure id=\"" + escaped(drawing.name) + "\">\n" + inColoursOfPage(drawing.svg) + "<figcaption><strong>" +
           escaped(drawing.title) + ".</strong> " + escaped(drawing.caption) + "</figcaption>\n</figure>\n";
  }

  void operator()(const ReportPicture& picture) {
    const auto bytes = readFile(picture.file, kMostPictureBytes);
    if (!bytes) {
      error = bytes.error();
      return;
    }
    out += "<figure>\n<img alt=\"" + escaped(picture.caption) + "\" src=\"data:image/png;base64," + base64(*bytes) +
           "\"/>\n<figcaption>" + escaped(picture.caption) + "</figcaption>\n</figure>\n";
  }

 private:
  void addTitles(const ReportTable& table) {
    out += "<thead><tr>";
    for (const ReportColumn& column : table.columns) {
      out += std::string("<th") + (column.kind == ReportColumn::Kind::Number ? " class=\"number\"" : "") + ">" +
             escaped(column.title) + "</th>";
    }
    out += "</tr></thead>\n";
  }
};

}  // namespace

std::string base64(const std::string& bytes) {
  static constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const bool padding = i + j > bytes.size();
      text += padding ? '=' : kDigits[group >> (18U - 6U * j) & 63U];
    }
  }
  return text;
}

Result<std::string> reportHtml(const Report& report) {
  Page page;
  for (const ReportBlock& block : report.blocks) std::visit(page, block);
  if (page.error) return *page.error;
  return "<!DOCTYPE html>\n<html lang=\"" + std::string(code(report.language)) +
         "\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
         "charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta name=\"color-scheme\" "
         "content=\"light dark\"/>\n<title>" +
         escaped(report.title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" +
         escaped(report.title) + "</h1>\n" + page.out + "</body>\n</html>\n";
}

}  // namespace glissade
