#include "tests/oracle/trapped_pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

namespace glissade::oracle {
namespace {

enum class Shape { Prism, Knob, Dovetail, Gear, Insert };
/// Additional fits of the pair: none; a pin below, thicker than its hole by the overlap or of equal thickness; a pin
/// with a transition to the flange by slopes below 36 degrees; one wall of the cavity that is pressed in.
enum class FitPlace { None, ThickPin, EqualPin, SmoothPin, Bump };

constexpr const char* kShapes[] = {"prism", "knob", "dovetail", "gear", "insert"};
constexpr const char* kFits[] = {"no fit", "thick pin", "equal pin", "smooth pin", "bump"};

class PairMaker {
 public:
  PairMaker(std::uint64_t seed, std::uint64_t number, double leastLip) : leastLip_(leastLip) {
    std::seed_seq words{seed, number, std::uint64_t{0x11b}};
    random_.seed(words);
    shape_ = static_cast<Shape>(number % 5);
    fit_ = number / 5 % 2 == 0 ? FitPlace::None : static_cast<FitPlace>(1 + below(4));
    if (shape_ == Shape::Gear && fit_ == FitPlace::SmoothPin) fit_ = FitPlace::ThickPin;  // no plane slopes to teeth
    trapped_ = below(4) != 0;
  }

  TrappedPair make() {
    drawSizes();
    std::ostringstream name;
    name << (trapped_ ? "" : "free ") << kShapes[static_cast<int>(shape_)] << ", " << corners_ << " corners, radius "
         << radius_ << ", lip " << pair_.lip << ", " << kFits[static_cast<int>(fit_)];
    if (pair_.fit > 0.0) name << " " << pair_.fit;
    addPin();
    addFlange();
    pair_.name = name.str() + (pair_.round ? ", round" : "");
    return pair_;
  }

 private:
  std::uint64_t below(std::uint64_t count) { return random_() % count; }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }

  void drawSizes() {
    radius_ = std::exp(uniform(std::log(5.0), std::log(100.0)));
    height_ = uniform(0.3, 0.8) * radius_;
    clear_ = uniform(0.01, 0.03) * radius_;
    const double few = fit_ == FitPlace::Bump || fit_ == FitPlace::SmoothPin ? 12.0 : 3.0;
    corners_ = static_cast<int>(std::exp(uniform(std::log(few), std::log(200.99))));
    if (shape_ == Shape::Gear) corners_ = 4 * std::max(3, corners_ / 4);
    pair_.round = shape_ != Shape::Gear && fit_ != FitPlace::Bump && corners_ >= 48;
    // Teeth are steep: a corner of a thinned body moves by at most two allowances.
    pair_.corner = shape_ == Shape::Gear ? 2.0 : 1.0 / std::cos(std::numbers::pi / corners_);
    const double least = leastLip_ + 2e-4 * radius_;
    const double most = 0.01 * radius_;
    pair_.lip = trapped_ ? std::exp(uniform(std::log(least), std::log(std::max(most, 1.01 * least)))) : 0.0;
    if (fit_ == FitPlace::None || fit_ == FitPlace::EqualPin) return;
    pair_.fit = std::min({0.2, 0.02 * radius_, std::max(2.0 * pair_.lip, 0.004 * radius_)});
  }

  Outline polygon(double radius) const { return polarOutline(corners_, {radius}); }

  /// The outline of a gear: teeth with this tip radius, and the lower corners between them.
  Outline teeth(double radius, double lower) const { return polarOutline(corners_, {radius, radius, lower, lower}); }

  Outline flange(double more = 0.0) const {
    return shape_ == Shape::Gear ? teeth(radius_ + more, 0.85 * radius_ + more) : polygon(radius_ + more);
  }

  Outline cavity() const {
    Outline outline = polygon(radius_ + clear_);
    if (fit_ != FitPlace::Bump) return outline;
    const Outline within = flange(-pair_.fit);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) outline[i] = within[i];
    return outline;
  }

  Outline opening() const {
    if (!trapped_) {
      Outline outline = cavity();
      return outline;
    }
    if (shape_ != Shape::Gear) return polygon(radius_ - pair_.lip);
    const double tip = radius_ - pair_.lip;  // the teeth of the body lie under the gaps between the teeth of the lip
    return teeth(tip, std::max(tip, radius_ + clear_));
  }

  bool hasPin() const { return fit_ != FitPlace::None && fit_ != FitPlace::Bump; }

  /// Adds the pin. The rings of the block go from its outer bottom to the bottom of its cavity; the rings after the
  /// opening are saved first.
  void addPin() {
    if (!hasPin()) return;
    const double pin = 0.5 * radius_;
    const double length = 0.6 * radius_;
    const double below = fit_ == FitPlace::SmoothPin ? -radius_ : 0.0;  // a slope of 30 degrees
    pair_.object.push_back({polygon(pin), below - length});
    pair_.object.push_back({polygon(pin), below});
    const double hole = pin - pair_.fit;
    cavityEnd_.push_back({polygon(hole), below - clear_});
    cavityEnd_.push_back({polygon(hole), below - length - clear_});
    bottom_ = below - length - clear_;
  }

  void addFlange() {
    std::vector<Ring>& object = pair_.object;
    const double ceiling = height_ + clear_;
    pair_.top = ceiling + 0.2 * radius_;
    const bool dovetail = shape_ == Shape::Dovetail;
    object.push_back({flange(), 0.0});
    object.push_back({dovetail ? polygon(0.8 * radius_) : flange(), height_});
    if (shape_ == Shape::Knob || shape_ == Shape::Insert) {
      object.push_back({polygon(0.6 * radius_), height_});
      object.push_back({polygon(0.6 * radius_), (shape_ == Shape::Knob ? 1.4 : 1.1) * pair_.top});
    }
    const double floor = fit_ == FitPlace::SmoothPin ? -radius_ - clear_ : -clear_;
    bottom_ = std::min(bottom_, floor) - 0.3 * radius_;
    std::vector<Ring>& block = pair_.block;
    block.push_back({polygon(2.5 * radius_), bottom_});
    block.push_back({polygon(2.5 * radius_), pair_.top});
    block.push_back({opening(), pair_.top});
    if (trapped_ && !dovetail) block.push_back({opening(), ceiling});
    if (trapped_ && !dovetail) block.push_back({cavity(), ceiling});
    if (trapped_ && dovetail) block.push_back({cavity(), 0.0});
    block.push_back({cavity(), floor});
    block.insert(block.end(), cavityEnd_.begin(), cavityEnd_.end());
  }

  std::mt19937_64 random_;
  double leastLip_;
  Shape shape_ = Shape::Prism;
  FitPlace fit_ = FitPlace::None;
  bool trapped_ = true;
  double radius_ = 0.0;
  double height_ = 0.0;
  double clear_ = 0.0;
  int corners_ = 0;
  double bottom_ = 0.0;
  TrappedPair pair_;
  std::vector<Ring> cavityEnd_;
};

}  // namespace

TrappedPair trappedPair(std::uint64_t seed, std::uint64_t number, double leastLip) {
  return PairMaker(seed, number, leastLip).make();
}

}  // namespace glissade::oracle
