#include "engine/model/designation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

#include "engine/geometry/thread_standards.h"

namespace glissade {
namespace {

/// The table that gives the key of a hexagon socket for a diameter.
enum class KeyTable { None, Cap, Button, Set, Wrench };

struct StandardRow {
  std::string_view number;  ///< after "ISO" or "DIN"
  bool isIso;
  StandardPart part;
  DriveKind drive;
  KeyTable keys;
  ThreadFamily threads = ThreadFamily::Metric;
};

constexpr bool kIso = true;
constexpr bool kDin = false;
using enum StandardPart;
constexpr auto kSocketDrive = DriveKind::HexSocket;
constexpr auto kHexDrive = DriveKind::HexOutside;
constexpr auto kTapping = ThreadFamily::Tapping;
constexpr auto kWood = ThreadFamily::Wood;

/// Parts and drives, by the standards' titles.
constexpr std::array kStandards{StandardRow{"4762", kIso, Screw, kSocketDrive, KeyTable::Cap},
                                StandardRow{"912", kDin, Screw, kSocketDrive, KeyTable::Cap},
                                StandardRow{"7984", kDin, Screw, kSocketDrive, KeyTable::Button},
                                StandardRow{"6912", kDin, Screw, kSocketDrive, KeyTable::Cap},
                                StandardRow{"7380", kIso, Screw, kSocketDrive, KeyTable::Button},
                                StandardRow{"10642", kIso, Screw, kSocketDrive, KeyTable::Button},
                                StandardRow{"7991", kDin, Screw, kSocketDrive, KeyTable::Button},
                                StandardRow{"4014", kIso, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4016", kIso, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4017", kIso, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4018", kIso, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"931", kDin, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"933", kDin, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"6921", kDin, Screw, kHexDrive, KeyTable::Wrench},
                                StandardRow{"7045", kIso, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"7046", kIso, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"7047", kIso, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"7048", kIso, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"7049", kIso, Screw, DriveKind::Cross, KeyTable::None, kTapping},
                                StandardRow{"7050", kIso, Screw, DriveKind::Cross, KeyTable::None, kTapping},
                                StandardRow{"965", kDin, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"966", kDin, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"7981", kDin, Screw, DriveKind::Cross, KeyTable::None, kTapping},
                                StandardRow{"7982", kDin, Screw, DriveKind::Cross, KeyTable::None, kTapping},
                                StandardRow{"7985", kDin, Screw, DriveKind::Cross, KeyTable::None},
                                StandardRow{"1207", kIso, Screw, DriveKind::Slot, KeyTable::None},
                                StandardRow{"1580", kIso, Screw, DriveKind::Slot, KeyTable::None},
                                StandardRow{"2009", kIso, Screw, DriveKind::Slot, KeyTable::None},
                                StandardRow{"84", kDin, Screw, DriveKind::Slot, KeyTable::None},
                                StandardRow{"85", kDin, Screw, DriveKind::Slot, KeyTable::None},
                                StandardRow{"963", kDin, Screw, DriveKind::Slot, KeyTable::None},
                                StandardRow{"14579", kIso, Screw, DriveKind::SixLobe, KeyTable::None},
                                StandardRow{"14580", kIso, Screw, DriveKind::SixLobe, KeyTable::None},
                                StandardRow{"14581", kIso, Screw, DriveKind::SixLobe, KeyTable::None},
                                StandardRow{"14583", kIso, Screw, DriveKind::SixLobe, KeyTable::None},
                                StandardRow{"14585", kIso, Screw, DriveKind::SixLobe, KeyTable::None, kTapping},
                                StandardRow{"14586", kIso, Screw, DriveKind::SixLobe, KeyTable::None, kTapping},
                                StandardRow{"14587", kIso, Screw, DriveKind::SixLobe, KeyTable::None, kTapping},
                                StandardRow{"7051", kIso, Screw, DriveKind::Cross, KeyTable::None, kTapping},
                                StandardRow{"7983", kDin, Screw, DriveKind::Cross, KeyTable::None, kTapping},
                                StandardRow{"1479", kIso, Screw, kHexDrive, KeyTable::None, kTapping},
                                StandardRow{"7976", kDin, Screw, kHexDrive, KeyTable::None, kTapping},
                                StandardRow{"1481", kIso, Screw, DriveKind::Slot, KeyTable::None, kTapping},
                                StandardRow{"1482", kIso, Screw, DriveKind::Slot, KeyTable::None, kTapping},
                                StandardRow{"1483", kIso, Screw, DriveKind::Slot, KeyTable::None, kTapping},
                                StandardRow{"7971", kDin, Screw, DriveKind::Slot, KeyTable::None, kTapping},
                                StandardRow{"7972", kDin, Screw, DriveKind::Slot, KeyTable::None, kTapping},
                                StandardRow{"7973", kDin, Screw, DriveKind::Slot, KeyTable::None, kTapping},
                                StandardRow{"95", kDin, Screw, DriveKind::Slot, KeyTable::None, kWood},
                                StandardRow{"96", kDin, Screw, DriveKind::Slot, KeyTable::None, kWood},
                                StandardRow{"97", kDin, Screw, DriveKind::Slot, KeyTable::None, kWood},
                                StandardRow{"571", kDin, Screw, kHexDrive, KeyTable::Wrench, kWood},
                                StandardRow{"7995", kDin, Screw, DriveKind::Cross, KeyTable::None, kWood},
                                StandardRow{"7996", kDin, Screw, DriveKind::Cross, KeyTable::None, kWood},
                                StandardRow{"7997", kDin, Screw, DriveKind::Cross, KeyTable::None, kWood},
                                StandardRow{"4026", kIso, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"4027", kIso, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"4028", kIso, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"4029", kIso, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"913", kDin, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"914", kDin, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"915", kDin, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"916", kDin, SetScrew, kSocketDrive, KeyTable::Set},
                                StandardRow{"551", kDin, SetScrew, DriveKind::Slot, KeyTable::None},
                                StandardRow{"553", kDin, SetScrew, DriveKind::Slot, KeyTable::None},
                                StandardRow{"4032", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4033", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4034", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4035", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"4161", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"7040", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"10511", kIso, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"934", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"936", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"439", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"982", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"985", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"1587", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"6923", kDin, Nut, kHexDrive, KeyTable::Wrench},
                                StandardRow{"557", kDin, Nut, DriveKind::None, KeyTable::None},
                                StandardRow{"562", kDin, Nut, DriveKind::None, KeyTable::None},
                                StandardRow{"7089", kIso, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"7090", kIso, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"7091", kIso, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"7092", kIso, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"7093", kIso, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"125", kDin, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"127", kDin, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"433", kDin, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"6796", kDin, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"9021", kDin, Washer, DriveKind::None, KeyTable::None},
                                StandardRow{"2338", kIso, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"2339", kIso, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"2341", kIso, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"8734", kIso, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"8752", kIso, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"7", kDin, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"1481", kDin, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"6325", kDin, Pin, DriveKind::None, KeyTable::None},
                                StandardRow{"15", kIso, Bearing, DriveKind::None, KeyTable::None},
                                StandardRow{"625", kDin, Bearing, DriveKind::None, KeyTable::None},
                                StandardRow{"471", kDin, Ring, DriveKind::None, KeyTable::None},
                                StandardRow{"472", kDin, Ring, DriveKind::None, KeyTable::None},
                                StandardRow{"6799", kDin, Ring, DriveKind::None, KeyTable::None},
                                StandardRow{"3601", kIso, Seal, DriveKind::None, KeyTable::None},
                                StandardRow{"3760", kDin, Seal, DriveKind::None, KeyTable::None},
                                StandardRow{"3771", kDin, Seal, DriveKind::None, KeyTable::None}};

/// Words of names; capitals, spaces, hyphens and underscores are ignored.
struct WordRow {
  std::string_view word;
  StandardPart part;
  DriveKind drive;
  KeyTable keys;
  ThreadFamily threads = ThreadFamily::Metric;
};

/// The first of these words in the name counts.
constexpr std::array kWords{WordRow{"heat-set", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"heat insert", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"threaded insert", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"brass insert", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"insert nut", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"rivnut", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"rivet nut", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"helicoil", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"self-clinching", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"clinch nut", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"press-in nut", Insert, DriveKind::None, KeyTable::None},
                            WordRow{"set screw", SetScrew, kSocketDrive, KeyTable::Set},
                            WordRow{"grub screw", SetScrew, kSocketDrive, KeyTable::Set},
                            WordRow{"self-tapping", Screw, DriveKind::None, KeyTable::None, kTapping},
                            WordRow{"tapping screw", Screw, DriveKind::None, KeyTable::None, kTapping},
                            WordRow{"sheet metal screw", Screw, DriveKind::None, KeyTable::None, kTapping},
                            WordRow{"blechschraube", Screw, DriveKind::None, KeyTable::None, kTapping},
                            WordRow{"autotaraudeuse", Screw, DriveKind::None, KeyTable::None, kTapping},
                            WordRow{"wood screw", Screw, DriveKind::None, KeyTable::None, kWood},
                            WordRow{"chipboard screw", Screw, DriveKind::None, KeyTable::None, kWood},
                            WordRow{"lag screw", Screw, kHexDrive, KeyTable::Wrench, kWood},
                            WordRow{"coach screw", Screw, kHexDrive, KeyTable::Wrench, kWood},
                            WordRow{"holzschraube", Screw, DriveKind::None, KeyTable::None, kWood},
                            WordRow{"vis a bois", Screw, DriveKind::None, KeyTable::None, kWood},
                            WordRow{"phillips", Screw, DriveKind::Cross, KeyTable::None},
                            WordRow{"philips", Screw, DriveKind::Cross, KeyTable::None},
                            WordRow{"torx", Screw, DriveKind::SixLobe, KeyTable::None},
                            WordRow{"SHCS", Screw, kSocketDrive, KeyTable::Cap},
                            WordRow{"BHCS", Screw, kSocketDrive, KeyTable::Button},
                            WordRow{"FHCS", Screw, kSocketDrive, KeyTable::Button},
                            WordRow{"button head", Screw, kSocketDrive, KeyTable::Button},
                            WordRow{"low profile screw", Screw, kSocketDrive, KeyTable::Button},
                            WordRow{"socket head", Screw, kSocketDrive, KeyTable::Cap},
                            WordRow{"socket cap", Screw, kSocketDrive, KeyTable::Cap},
                            WordRow{"slotted screw", Screw, DriveKind::Slot, KeyTable::None},
                            WordRow{"hex bolt", Screw, kHexDrive, KeyTable::Wrench},
                            WordRow{"hex head bolt", Screw, kHexDrive, KeyTable::Wrench},
                            WordRow{"hex head screw", Screw, kHexDrive, KeyTable::Wrench},
                            WordRow{"cap screw", Screw, DriveKind::None, KeyTable::None},
                            WordRow{"machine screw", Screw, DriveKind::None, KeyTable::None},
                            WordRow{"lock nut", Nut, kHexDrive, KeyTable::Wrench},
                            WordRow{"nyloc nut", Nut, kHexDrive, KeyTable::Wrench},
                            WordRow{"hex nut", Nut, kHexDrive, KeyTable::Wrench},
                            WordRow{"square nut", Nut, DriveKind::None, KeyTable::None},
                            WordRow{"T-nut", Nut, DriveKind::None, KeyTable::None},
                            WordRow{"washer", Washer, DriveKind::None, KeyTable::None},
                            WordRow{"shim", Washer, DriveKind::None, KeyTable::None},
                            WordRow{"dowel", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"clevis pin", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"parallel pin", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"roll pin", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"spring pin", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"guide pin", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"zylinderstift", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"passstift", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"goupille", Pin, DriveKind::None, KeyTable::None},
                            WordRow{"ball bearing", Bearing, DriveKind::None, KeyTable::None},
                            WordRow{"bearing", Bearing, DriveKind::None, KeyTable::None},
                            WordRow{"bushing", Bearing, DriveKind::None, KeyTable::None},
                            WordRow{"O-ring", Seal, DriveKind::None, KeyTable::None},
                            WordRow{"circlip", Ring, DriveKind::None, KeyTable::None},
                            WordRow{"retaining ring", Ring, DriveKind::None, KeyTable::None},
                            WordRow{"screw", Screw, DriveKind::None, KeyTable::None},
                            WordRow{"bolt", Screw, DriveKind::None, KeyTable::None},
                            WordRow{"schraube", Screw, DriveKind::None, KeyTable::None},
                            WordRow{"mutter", Nut, DriveKind::None, KeyTable::None},
                            WordRow{"scheibe", Washer, DriveKind::None, KeyTable::None},
                            WordRow{"ecrou", Nut, DriveKind::None, KeyTable::None},
                            WordRow{"rondelle", Washer, DriveKind::None, KeyTable::None},
                            WordRow{"nut", Nut, DriveKind::None, KeyTable::None}};

/// Widths across flats, millimetres: ISO 4762, ISO 7380, ISO 4026, ISO 4017 (DIN 933 differs at M10, M12 and M14).
struct KeyRow {
  double diameter;
  double cap;
  double button;
  double set;
  double wrench;
};
constexpr std::array<KeyRow, 15> kKeys{{{1.6, 1.5, 0.9, 0.7, 3.2},
                                        {2.0, 1.5, 1.3, 0.9, 4.0},
                                        {2.5, 2.0, 1.5, 1.3, 5.0},
                                        {3.0, 2.5, 2.0, 1.5, 5.5},
                                        {3.5, 0.0, 0.0, 0.0, 6.0},
                                        {4.0, 3.0, 2.5, 2.0, 7.0},
                                        {5.0, 4.0, 3.0, 2.5, 8.0},
                                        {6.0, 5.0, 4.0, 3.0, 10.0},
                                        {8.0, 6.0, 5.0, 4.0, 13.0},
                                        {10.0, 8.0, 6.0, 5.0, 16.0},
                                        {12.0, 10.0, 8.0, 6.0, 18.0},
                                        {14.0, 12.0, 10.0, 6.0, 21.0},
                                        {16.0, 14.0, 10.0, 8.0, 24.0},
                                        {20.0, 17.0, 12.0, 10.0, 30.0},
                                        {24.0, 19.0, 14.0, 12.0, 36.0}}};

double keyFor(KeyTable table, double diameter) {
  const auto row = std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyRow& one) {
    return std::abs(1e-3 * one.diameter - diameter) < 0.03 * diameter;
  });
  if (row == kKeys.end()) return 0.0;
  switch (table) {
    case KeyTable::Cap: return 1e-3 * row->cap;
    case KeyTable::Button: return 1e-3 * row->button;
    case KeyTable::Set: return 1e-3 * row->set;
    case KeyTable::Wrench: return 1e-3 * row->wrench;
    case KeyTable::None: break;
  }
  return 0.0;
}

constexpr double kInch = 25.4e-3;
/// Relative difference within which sizes are equal: "ST4.2" has 4.22 mm.
constexpr double kSameSize = 0.02;

/// Number of characters of a name that are searched: patterns take memory by its length.
constexpr std::size_t kLongestName = 200;

double numberIn(const std::string& text) {
  std::string plain = text;
  std::replace(plain.begin(), plain.end(), ',', '.');
  std::istringstream stream(plain);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return value;
}

/// The size in a name, and its text.
struct SizeText {
  std::string text{};
  double diameter = 0.0;
  double length = 0.0;
  double pitch = 0.0;
};

/// A second number up to this share of the diameter is a pitch, because no screw is so short.
constexpr double kMostPitch = 0.3;

/// "M3x8", "M8 x 1.25 x 30", "M10x1.5", "M3".
std::optional<SizeText> metricSize(const std::string& name) {
  static const std::regex pattern(
      R"((?:^|[^A-Za-z0-9])[Mm] ?(\d{1,2}(?:[.,]\d{1,2})?)(?:\s*[xX*]\s*(\d{1,3}(?:[.,]\d{1,2})?))?(?:\s*[xX*]\s*(\d{1,3}(?:[.,]\d{1,2})?))?(?![0-9]))");
  std::smatch match;
  for (std::sregex_iterator each(name.begin(), name.end(), pattern), end; each != end; ++each) {
    // "M5_M5 x 20": the more complete size counts.
    const bool saysMore = match.empty() || (!match[2].matched && (*each)[2].matched);
    if (saysMore) match = *each;
  }
  if (match.empty()) return std::nullopt;
  SizeText size;
  size.diameter = 1e-3 * numberIn(match[1]);
  if (!(size.diameter >= 1e-3 && size.diameter <= 64e-3)) return std::nullopt;
  size.text = "M" + match[1].str();
  const double second = match[2].matched ? 1e-3 * numberIn(match[2]) : 0.0;
  const double third = match[3].matched ? 1e-3 * numberIn(match[3]) : 0.0;
  const bool isPitch = second > 0.0 && second <= kMostPitch * size.diameter;
  size.pitch = isPitch ? second : 0.0;
  size.length = isPitch ? third : second;
  if (match[2].matched) size.text += "x" + match[2].str();
  if (match[3].matched) size.text += "x" + match[3].str();
  return size;
}

/// The unified size of this diameter (metres); null if there is none.
const ThreadSize* unifiedOf(double diameter) {
  const ThreadSize& nearest = nearestThreadSize(ThreadFamily::Unified, diameter);
  return std::abs(nearest.diameter - diameter) < 1e-3 * diameter ? &nearest : nullptr;
}

/// Adds the length of a screw that the text begins with, in inches: "1/2", "1-1/4", ".375".
void addInches(const std::string& text, SizeText& size) {
  static const std::regex pattern(R"(^(?:(?:(\d{1,2})[- ])?(\d{1,2})/(\d{1,2})|(\d{0,2}\.?\d{1,4}))(?![\d./]))");
  std::smatch match;
  if (!std::regex_search(text, match, pattern)) return;
  const double inches = match[4].matched ? numberIn(match[4])
                                         : numberIn(match[1]) + numberIn(match[2]) / std::max(1.0, numberIn(match[3]));
  size.length = inches * kInch;
  size.text += "x" + match[0].str() + "\"";
}

/// "#10-32", "1/4-20", "1/4"-20 UNC", "10-32 x 1/2", "1/4 UNC", "#8 UNF": unified threads.
std::optional<SizeText> unifiedSize(const std::string& name) {
  static const std::regex pattern(
      R"re((?:(#|No\.? ?)(\d{1,2})|(?:^|[^0-9/_.])(\d{1,2})[/_](\d{1,2})"?|(?:^|[^0-9A-Za-z/_.-])(\d{1,2}))(?:[ ]?-[ ]?(\d{1,2})(?![0-9/])|[ _-]*(UNC|UNF)(?![A-Za-z]))([ _-]*(?:UNC|UNF)?[ _-]*[xX*][ _]*[\d.])?)re");
  for (std::sregex_iterator each(name.begin(), name.end(), pattern), end; each != end; ++each) {
    const std::smatch& match = *each;
    const bool isFraction = match[3].matched;
    const std::string number = isFraction ? std::string() : (match[2].matched ? match[2].str() : match[5].str());
    const double diameter = isFraction ? numberIn(match[3]) / std::max(1.0, numberIn(match[4])) * kInch
                                       : (0.06 + 0.013 * numberIn(number)) * kInch;
    const ThreadSize* known = unifiedOf(diameter);
    if (known == nullptr) continue;
    const double fine = known->finePitches.empty() ? 0.0 : known->finePitches.front();
    SizeText size;
    size.diameter = diameter;
    size.text = isFraction ? match[3].str() + "/" + match[4].str() : "#" + number;
    if (match[7].matched) {
      size.pitch = match[7] == "UNF" ? fine : known->pitch;
      size.text += " " + match[7].str();
    } else {
      size.pitch = kInch / numberIn(match[6]);
      size.text += "-" + match[6].str();
    }
    const auto isOne = [&](double pitch) { return std::abs(size.pitch - pitch) < 1e-3 * size.pitch; };
    const bool isStandard = isOne(known->pitch) || isOne(fine);
    // "10-32" alone may be any two numbers.
    const bool isSure = isFraction || match[1].matched || (isStandard && (match[7].matched || match[8].matched));
    if (!isSure || !(size.pitch > 0.0)) continue;
    if (match[8].matched) addInches(name.substr(static_cast<std::size_t>(match.position() + match.length() - 1)), size);
    return size;
  }
  return std::nullopt;
}

/// "ST4.2x35", and "4.2 x 35" for a screw that its standard or a word identifies (`isKnown`).
std::optional<SizeText> sizeOfFamily(const std::string& name, ThreadFamily family, bool isKnown) {
  static const std::regex pattern(
      R"((?:^|[^A-Za-z0-9.,])(ST ?)?(\d{1,2}(?:[.,]\d{1,2})?)(?:\s*[xX*]\s*(\d{1,3}(?:[.,]\d{1,2})?))?(?![0-9]))");
  for (std::sregex_iterator each(name.begin(), name.end(), pattern), end; each != end; ++each) {
    const std::smatch& match = *each;
    if (!match[1].matched && !(isKnown && match[3].matched)) continue;
    SizeText size;
    size.diameter = 1e-3 * numberIn(match[2]);
    size.length = match[3].matched ? 1e-3 * numberIn(match[3]) : 0.0;
    size.text = (match[1].matched ? "ST" : "") + match[2].str() + (match[3].matched ? "x" + match[3].str() : "");
    const ThreadSize& known = nearestThreadSize(family, size.diameter);
    if (std::abs(known.diameter - size.diameter) > kSameSize * size.diameter) continue;
    size.pitch = known.pitch;
    return size;
  }
  return std::nullopt;
}

/// A screw that cuts its thread has the pitch of its family, whatever the name of its size: "M3x10 self-tapping".
std::optional<SizeText> sizeIn(const std::string& name, ThreadFamily family) {
  auto size = metricSize(name);
  if (!size) size = unifiedSize(name);
  if (family == ThreadFamily::Metric) return size;
  if (!size) return sizeOfFamily(name, family, true);
  size->pitch = nearestThreadSize(family, size->diameter).pitch;
  return size;
}

/// "M10 LH", "left hand".
bool isLeftHanded(const std::string& name) {
  static const std::regex pattern(R"((^|[^A-Za-z])(LH|left[ _-]?hand(ed)?|linksgewinde|pas (a|à) gauche)($|[^A-Za-z]))",
                                  std::regex::icase);
  return std::regex_search(name, pattern);
}

const StandardRow* standardIn(const std::string& name, std::string* text, bool* isUnknown) {
  static const std::regex pattern(
      R"((?:^|[^A-Za-z])(?:(DIN)[ _-]?(?:EN[ _-]?)?(ISO[ _-]?)?|(?:EN[ _-]?)?(ISO)[ _-]?)(\d{1,5}))",
      std::regex::icase);
  for (std::sregex_iterator match(name.begin(), name.end(), pattern), end; match != end; ++match) {
    const bool isIso = (*match)[2].matched || (*match)[3].matched;
    const std::string number = (*match)[4];
    const auto row = std::find_if(kStandards.begin(), kStandards.end(),
                                  [&](const StandardRow& one) { return one.isIso == isIso && one.number == number; });
    *text = std::string(isIso ? "ISO " : "DIN ") + number;
    if (row != kStandards.end()) return &*row;
    *isUnknown = true;
  }
  return nullptr;
}

std::string plainWord(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c != ' ' && c != '-' && c != '_') {
      plain += ' ';
    }
  }
  return plain;
}

/// 608, 623ZZ, F688, MR105, 6005-2RS.
std::optional<Designation> bearingIn(const std::string& name) {
  static const std::regex pattern(
      R"((?:^|[^A-Za-z0-9.])(?:F|FAG|SKF)?((?:6[0-9]{2,3}|MR[0-9]{2,4})[ _-]?(?:ZZ|2RSR?|RS|2Z|DD|LLU)|6(?:0[0-9]|2[0-9]|8[0-9]|9[0-9])(?:0[0-9])?|MR[0-9]{2,4})(?![A-Za-z0-9.]))");
  std::smatch match;
  if (!std::regex_search(name, match, pattern)) return std::nullopt;
  Designation found;
  found.part = StandardPart::Bearing;
  found.text = match[1];
  return found;
}

Designation complete(StandardPart part, DriveKind drive, KeyTable keys, const std::string& text,
                     const std::optional<SizeText>& size) {
  Designation found{part, text};
  found.drive = drive;
  if (!size) return found;
  found.text += (text.empty() ? "" : " ") + size->text;
  found.diameter = size->diameter;
  found.length = size->length;
  found.pitch = size->pitch;
  found.driveSize = keyFor(keys, size->diameter);
  return found;
}

/// True if this is the last word of the name, which says what a part is.
bool isLastWord(const std::string& name, std::string_view word) {
  std::string letters;
  for (const char c : name) letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t last = letters.find_last_of("abcdefghijklmnopqrstuvwxyz");
  if (last == std::string::npos || last + 1 < word.size()) return false;
  const std::size_t first = last + 1 - word.size();
  const bool isWhole = first == 0 || std::isalpha(static_cast<unsigned char>(letters[first - 1])) == 0;
  return isWhole && letters.compare(first, word.size(), word) == 0;
}

/// Names of a large maker: standoffs SO-M3-6, BSO-M3-8, SOS-M4-10, nuts CLS-M3-1, S-M4-2, SP-M5-1.
bool isSelfClinching(const std::string& name) {
  static const std::regex pattern(R"((^|[^A-Za-z0-9])(B?SO[SA4]?|TSO[SA]?|CLSS?|CLA|SP?)-M\d+(-\d+)?($|[^A-Za-z0-9]))");
  return std::regex_search(name, pattern);
}

std::optional<Designation> readByWord(const std::string& name) {
  const std::string plain = plainWord(name);
  for (const WordRow& row : kWords) {
    if (plain.find(plainWord(std::string(row.word))) == std::string::npos) continue;
    const auto size = sizeIn(name, row.threads);
    // A common word is a hint only beside a size, or as the last word.
    const bool isCommon = row.word == "nut" || row.word == "bolt" || row.word == "shim";
    if (isCommon && !size && !isLastWord(name, row.word)) continue;
    if (row.part == StandardPart::Bearing) {
      if (auto bearing = bearingIn(name)) return bearing;
    }
    return complete(row.part, row.drive, row.keys, std::string(row.word), size);
  }
  return std::nullopt;
}

/// "M3x8", "ST4.2x35", "10-32 x 1/2", "SO-M3-6".
std::optional<Designation> readBySize(const std::string& name) {
  auto size = sizeIn(name, ThreadFamily::Metric);
  if (size && isSelfClinching(name)) return complete(StandardPart::Insert, DriveKind::None, KeyTable::None, "", size);
  if (!size) size = sizeOfFamily(name, ThreadFamily::Tapping, false);
  if (!size || !(size->length > 0.0)) return std::nullopt;
  // M3x5x4: diameter, length and outer diameter of an insert.
  static const std::regex insert(R"([Mm]\d+(?:[.,]\d+)?\s*[xX]\s*\d+(?:[.,]\d+)?\s*[xX]\s*\d+(?:[.,]\d+)?)");
  const bool isInsert = size->pitch == 0.0 && std::regex_search(name, insert);
  return complete(isInsert ? StandardPart::Insert : StandardPart::Screw, DriveKind::None, KeyTable::None, "", size);
}

std::optional<Designation> readPart(const std::string& name, bool* isUnknown) {
  std::string text;
  if (const StandardRow* row = standardIn(name, &text, isUnknown)) {
    return complete(row->part, row->drive, row->keys, text, sizeIn(name, row->threads));
  }
  if (auto found = readByWord(name)) return found;
  if (auto bearing = bearingIn(name)) return bearing;
  return readBySize(name);
}

std::optional<Designation> readDesignation(const std::string& name, bool* isUnknown) {
  auto found = readPart(name, isUnknown);
  if (!found || found->diameter <= 0.0 || !isLeftHanded(name)) return found;
  const double pitch = found->pitch > 0.0 ? found->pitch : usualThreadSize(found->diameter).pitch;
  found->pitch = -pitch;
  found->text += " LH";
  return found;
}

}  // namespace

std::optional<Designation> designationIn(const std::string& name) {
  bool isUnknown = false;
  return readDesignation(name.substr(0, kLongestName), &isUnknown);
}

Result<Designation> designationOf(const std::string& text) {
  bool isUnknown = false;
  const auto found = readDesignation(text.substr(0, kLongestName), &isUnknown);
  if (found && !isUnknown) return *found;
  const CatalogueText reason = isUnknown ? GLISSADE_TEXT("'%1' names a standard that is not known")
                                         : GLISSADE_TEXT("'%1' is no designation of a standard part that is known");
  return Diagnostic{ErrorKind::Usage,
                    "",
                    "",
                    {reason, {text}},
                    GLISSADE_TEXT("Give one as 'ISO 4762 M3x8', 'DIN 934 M5' or 'M3x8 SHCS'.")};
}

bool isShaftName(const std::string& name) {
  constexpr std::array<std::string_view, 14> kWordsOfShafts{"rod",     "shaft", "axle",  "axis",    "pin",
                                                            "spindle", "pivot", "stift", "achse",   "welle",
                                                            "axe",     "tige",  "arbre", "goupille"};
  return std::any_of(kWordsOfShafts.begin(), kWordsOfShafts.end(),
                     [&](std::string_view word) { return isLastWord(name, word); });
}

double usualDriveSize(DriveKind drive, double diameter) {
  if (drive == DriveKind::HexSocket) return keyFor(KeyTable::Cap, diameter);
  if (drive == DriveKind::HexOutside) return keyFor(KeyTable::Wrench, diameter);
  return 0.0;
}

}  // namespace glissade
