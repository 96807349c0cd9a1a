#include "engine/documents/xml_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace glissade {

std::string escaped(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20U || c == '\n' || c == '\t') {
      out += c;
    }
  }
  return out;
}

std::string pixels(double value) {
  std::array<char, 64> buffer{};
  const double rounded = std::round(value * 100.0) / 100.0 + 0.0;  // + 0.0: no "-0"
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded, std::chars_format::fixed, 2);
  std::string text(buffer.data(), end.ptr);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string svgBegin(double width, double height, const std::string& ground) {
  const std::string size = "width=\"" + pixels(width) + "\" height=\"" + pixels(height) + "\"";
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " viewBox=\"0 0 " + pixels(width) + " " +
         pixels(height) + "\">\n<rect " + size + " fill=\"" + ground + "\"/>\n";
}

std::string svgText(double x, double y, const std::string& anchor, const std::string& text, const std::string& colour) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor +
         "\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\" fill=\"" + colour + "\">" + escaped(text) +
         "</text>\n";
}

}  // namespace glissade
