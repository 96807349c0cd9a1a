#include "engine/import/foreign_text.h"

#include <iconv.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>

#include "engine/base/utf8.h"

namespace glissade {
namespace {

using Byte = unsigned char;

enum Encoding : std::size_t { Gb18030, ShiftJis, Windows1252 };
/// Names for the C library, and names for people.
constexpr std::array<const char*, 3> kConverterNames{"GB18030", "CP932", "CP1252"};
constexpr std::array<const char*, 3> kShownNames{"GB18030", "Shift JIS", "Windows-1252"};

/// iconv_open() returns -1 if the C library does not have an encoding.
bool isLoaded(iconv_t converter) { return reinterpret_cast<std::intptr_t>(converter) != -1; }

bool isIn(Byte byte, Byte first, Byte last) { return byte >= first && byte <= last; }
bool isHigh(Byte byte) { return byte >= 0x80; }

/// In UTF-8, what is no character.
constexpr std::string_view kUnknown = "\xef\xbf\xbd";

/// The number of bytes of a character that is cut at the end of UTF-8, two or three; 0: nothing is cut. Programs cut
/// long names, and not always between characters. One byte alone may be a letter of Windows-1252.
std::size_t cutBytesOf(std::string_view name) {
  for (const std::size_t count : {std::size_t{2}, std::size_t{3}}) {
    if (name.size() < count) break;
    const std::string_view cut = name.substr(name.size() - count);
    const bool isLead = isIn(static_cast<Byte>(cut.front()), count == 2 ? 0xe0 : 0xf0, 0xf4);
    const bool goesOn =
        std::all_of(cut.begin() + 1, cut.end(), [](char c) { return isIn(static_cast<Byte>(c), 0x80, 0xbf); });
    if (isLead && goesOn && isUtf8(name.substr(0, name.size() - count))) return count;
  }
  return 0;
}

/// Number of high bytes in names, and of those that belong to usual characters of an encoding.
struct Usual {
  std::size_t high = 0;
  std::size_t usual = 0;
  bool isValid = true;

  double share() const { return isValid && high > 0 ? static_cast<double>(usual) / static_cast<double>(high) : 0.0; }
};

/// Usual characters: the 3755 most frequent Chinese characters and the signs of GB 2312.
void countGb18030(std::string_view name, Usual& counts) {
  for (std::size_t at = 0; at < name.size(); ++at) {
    const auto lead = static_cast<Byte>(name[at]);
    if (!isHigh(lead)) continue;
    const Byte trail = at + 1 < name.size() ? static_cast<Byte>(name[at + 1]) : 0;
    const bool isFour = isIn(trail, 0x30, 0x39) && at + 3 < name.size();
    if (lead == 0x80 || lead == 0xff || (trail < 0x40 && !isFour) || trail == 0x7f || trail == 0xff) {
      counts.isValid = false;
      return;
    }
    const bool isUsual = trail >= 0xa1 && (isIn(lead, 0xb0, 0xd7) || isIn(lead, 0xa1, 0xa3));
    counts.high += 2;
    if (isUsual) counts.usual += 2;
    at += isFour ? 3 : 1;
  }
}

/// Usual characters: kana, signs and the 2965 most frequent kanji; half-width kana in groups.
void countShiftJis(std::string_view name, Usual& counts) {
  for (std::size_t at = 0; at < name.size(); ++at) {
    const auto lead = static_cast<Byte>(name[at]);
    if (!isHigh(lead)) continue;
    if (isIn(lead, 0xa1, 0xdf)) {
      ++counts.high;
      if (at > 0 && isIn(static_cast<Byte>(name[at - 1]), 0xa1, 0xdf)) ++counts.usual;
      continue;
    }
    const Byte trail = at + 1 < name.size() ? static_cast<Byte>(name[at + 1]) : 0;
    if (lead == 0x80 || lead == 0xa0 || lead > 0xfc || trail < 0x40 || trail == 0x7f || trail > 0xfc) {
      counts.isValid = false;
      return;
    }
    const bool isKana = (lead == 0x82 && trail >= 0x4f) || (lead == 0x83 && trail <= 0x96) || lead == 0x81;
    counts.high += 2;
    if (isKana || isIn(lead, 0x88, 0x98)) counts.usual += 2;
    ++at;
  }
}

/// Usual characters: small letters after a letter, capitals beside an ASCII letter, and signs of drawings, one or two
/// together.
void countWindows1252(std::string_view name, Usual& counts) {
  const auto byteAt = [&](std::size_t at) { return at < name.size() ? static_cast<Byte>(name[at]) : Byte{' '}; };
  const auto isLetter = [](Byte byte) { return std::isalpha(byte) != 0 && byte < 0x80; };
  const auto isSmall = [](Byte byte) { return byte >= 0xdf && byte != 0xf7; };
  constexpr std::string_view kSigns =
      "\xa0\xa7\xa9\xae\xb0\xb1\xb2\xb3\xb5\xb7\xbc\xbd\xbe\xd7\xd8\xf8\x80\x96\x97\x99";
  for (std::size_t at = 0; at < name.size(); ++at) {
    const Byte byte = byteAt(at);
    if (!isHigh(byte)) continue;
    ++counts.high;
    const bool isRun = isHigh(byteAt(at - 1)) && (isHigh(byteAt(at - 2)) || isHigh(byteAt(at + 1)));
    const bool isSign = kSigns.find(static_cast<char>(byte)) != std::string_view::npos && !isHigh(byteAt(at + 1));
    const bool isSmallLetter =
        isSmall(byte) && (isLetter(byteAt(at - 1)) || isSmall(byteAt(at - 1)) || isLetter(byteAt(at + 1)));
    const bool isCapital =
        isIn(byte, 0xc0, 0xde) && byte != 0xd7 && (isLetter(byteAt(at + 1)) || isLetter(byteAt(at - 1)));
    if (!isRun && (isSign || isSmallLetter || isCapital)) ++counts.usual;
  }
}

/// The pieces between apostrophes that are not UTF-8. An apostrophe is no trail byte of the encodings.
std::vector<std::string_view> foreignPiecesOf(std::string_view text) {
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\'', begin), text.size());
    if (!isUtf8(text.substr(begin, end - begin))) pieces.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return pieces;
}

struct Guess {
  std::size_t encoding = Windows1252;
  bool isSure = false;
};

Guess guessed(const std::vector<std::string_view>& pieces) {
  constexpr double kUsualShare = 0.7;
  constexpr double kLead = 0.2;
  std::array<Usual, 3> counts;
  for (const std::string_view name : pieces) {
    countGb18030(name, counts[Gb18030]);
    countShiftJis(name, counts[ShiftJis]);
    countWindows1252(name, counts[Windows1252]);
  }
  Guess best;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i].share() > counts[best.encoding].share()) best.encoding = i;
  }
  best.isSure = counts[best.encoding].share() >= kUsualShare;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (i != best.encoding && counts[i].share() > counts[best.encoding].share() - kLead) best.isSure = false;
  }
  if (counts[best.encoding].share() < kUsualShare) best.encoding = Windows1252;
  return best;
}

}  // namespace

ForeignText::ForeignText() {
  for (std::size_t i = 0; i < kEncodings; ++i) converters_[i] = ::iconv_open("UTF-8", kConverterNames[i]);
}

ForeignText::~ForeignText() {
  for (const Converter converter : converters_) {
    if (isLoaded(converter)) ::iconv_close(converter);
  }
}

/// Bytes that are no character of the encoding become U+FFFD; so do all if the C library does not have the encoding.
std::string ForeignText::decoded(std::string_view name, std::size_t encoding) const {
  constexpr std::size_t kMostBytes = 4;  // bytes of a character in UTF-8
  std::string in(name);
  std::string text(kMostBytes * in.size(), '\0');
  char* from = in.data();
  char* to = text.data();
  std::size_t left = in.size();
  std::size_t room = text.size();
  if (isLoaded(converters_[encoding])) ::iconv(converters_[encoding], nullptr, nullptr, nullptr, nullptr);
  while (left > 0) {
    const bool isKnown = isLoaded(converters_[encoding]);
    if (isKnown && ::iconv(converters_[encoding], &from, &left, &to, &room) != static_cast<std::size_t>(-1)) break;
    if (left == 0 || room < kMostBytes) break;
    const std::string_view unread = isHigh(static_cast<Byte>(*from)) ? kUnknown : std::string_view(from, 1);
    to = std::copy(unread.begin(), unread.end(), to);
    room -= unread.size();
    ++from;
    --left;
  }
  text.resize(text.size() - room);
  return text;
}

std::optional<ForeignNames> ForeignText::makeUtf8(std::vector<char>& text) const {
  const std::string_view before(text.data(), text.size());
  if (isUtf8(before)) return std::nullopt;
  const std::vector<std::string_view> pieces = foreignPiecesOf(before);
  std::vector<std::string_view> foreign;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(foreign),
               [](std::string_view piece) { return cutBytesOf(piece) == 0; });
  const Guess guess = guessed(foreign);
  ForeignNames read{kShownNames[guess.encoding], guess.isSure, ""};
  std::vector<char> after;
  after.reserve(text.size() + text.size() / 8);
  auto at = text.cbegin();
  for (const std::string_view piece : pieces) {
    const auto begin = text.cbegin() + (piece.data() - text.data());
    after.insert(after.end(), at, begin);
    const std::size_t cut = cutBytesOf(piece);
    const std::string utf8 =
        cut > 0 ? std::string(piece.substr(0, piece.size() - cut)).append(kUnknown) : decoded(piece, guess.encoding);
    if (cut == 0 && read.example.empty()) read.example = utf8;
    after.insert(after.end(), utf8.begin(), utf8.end());
    at = begin + static_cast<std::ptrdiff_t>(piece.size());
  }
  after.insert(after.end(), at, text.cend());
  text = std::move(after);
  return foreign.empty() ? std::nullopt : std::optional(std::move(read));
}

}  // namespace glissade
