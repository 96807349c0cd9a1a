// Generates the pump sample: a coolant pump that is mounted in and unmounted from a power-electronics frame, in the
// spirit of figure 16 of Cailhol et al. 2019. Metres, z up, the front of the frame towards -y.
//
//   pump      axis along its x, 0.35 long: finned motor (radius 0.078), adapter flange (0.11), volute (0.08), suction
//             port along the axis, discharge port up to z = 0.135, two feet down to z = -0.115. Origin: its middle.
//   frame     1.2 x 0.8 x 0.9: slotted posts (0.04) and rails (0.036), deck, shelf and rear panel, heat sinks and
//             capacitors, and the pump's seat: two pads with lips 22 mm high. The front opening is 0.25 wide, 15 mm
//             more than the flange on each side; every other opening is narrower than 0.15.
//   bracket   a gusseted plate in front of the seat, with a wing at its right end.
//   pipes     the discharge line 43 mm above the mounted pump, and the coolant line across the front, which leaves
//             0.28 above the lower rail for the 0.25 of the pump.
//   cables    wiring behind and on the right, and the hose of the suction coupling.
//   plug, coupling   the connectors of motor and suction port, parked beside the seat; mobile.
//
// The pump is lifted off its lips, shifted to the right between lips and discharge line (12 mm on each side), turned
// by 90 degrees about the vertical behind the opening, and drawn out end first under the coolant line.
//
// Usage: generate FOLDER, then glissade-cli convert F F for mount.json and unmount.json there: the committed files.

#include <CGAL/Polygon_mesh_processing/transform.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "samples/pump/shapes.h"

namespace glissade::sample {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
constexpr double kPost = 0.04;          // edge of posts
constexpr double kRail = 0.036;         // edge of rails
constexpr double kDeckTop = 0.202;      // height on which seat, bracket and pipes stand
constexpr double kShelfTop = 0.652;     // height of the shelf above the pump's room
constexpr double kPadTop = 0.25;        // height on which the pump's feet rest
constexpr double kSeatX = -0.2;         // x of the mounted pump's reference point
constexpr double kOpeningX = 0.25;      // middle of the front opening
constexpr double kOpeningWidth = 0.25;  // the flange's 0.22 and 15 mm on each side
constexpr double kFootBottom = -0.115;  // in the pump's frame
constexpr double kSeatGap = 0.003;      // between foot and pad when mounted
constexpr double kJoint = 0.0002;       // gap between bolted parts
constexpr double kPiece = 0.12;         // longest edge of triangles along a rail
constexpr std::array<double, 2> kFootX{-0.08, 0.07};

// The pump --------------------------------------------------------------------------------------------------------

/// Motor, adapter flange, volute and suction port.
Mesh pumpHousing() {
  Outline profile{{-0.175, 0.060}, {-0.173, 0.068}, {-0.169, 0.074}, {-0.163, 0.077}, {-0.128, 0.077},
                  {-0.127, 0.066}, {0.000, 0.066},  {0.001, 0.108},  {0.003, 0.110},  {0.017, 0.110},
                  {0.019, 0.108},  {0.020, 0.076},  {0.030, 0.076},  {0.034, 0.080}};
  for (int i = 0; i <= 12; ++i) {
    const auto [c, s] = onCircle(i, 48, 0);
    profile.push_back({0.100 + 0.028 * s, 0.046 + 0.034 * c});
  }
  const Outline port{{0.134, 0.034}, {0.158, 0.032}, {0.159, 0.048}, {0.161, 0.050},
                     {0.173, 0.050}, {0.175, 0.048}, {0.175, 0.022}, {0.130, 0.022}};
  profile.insert(profile.end(), port.begin(), port.end());
  return placed(revolution(profile, 64), Axis::X, CGAL::ORIGIN);
}

Mesh motorFins() {
  constexpr int kFins = 24;
  Mesh fins;
  for (int i = 0; i < kFins; ++i) {
    const auto [c, s] = onCircle(i, kFins, 0.5);
    if (std::abs(s) > 0.9) continue;  // the terminal box above, the foot below
    Mesh fin = boxAt(Point(-0.0635, 0.067, 0), 0.118, 0.022, 0.004);
    pmp::transform(Transform(1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0), fin);
    fins += fin;
  }
  return fins;
}

Mesh flangeBolts() {
  Mesh bolts;
  for (int i = 0; i < 8; ++i) {
    const auto [c, s] = onCircle(i, 8, 0.5);
    for (const double x : {-0.006, 0.0155})
      bolts += cylinder(Axis::X, Point(x, 0.096 * c, 0.096 * s), 0.0075, 0.0105, 6);
  }
  return bolts;
}

Mesh dischargePort() {
  const Outline profile{{0.050, 0.026}, {0.116, 0.024}, {0.117, 0.040}, {0.119, 0.042},
                        {0.133, 0.042}, {0.135, 0.040}, {0.135, 0.017}, {0.095, 0.017}};
  return placed(revolution(profile, 64), Axis::Z, Point(0.068, 0, 0));
}

/// Holes through the flanges of both ports.
Mesh portHoles() {
  Mesh holes;
  for (int i = 0; i < 4; ++i) {
    const auto [c, s] = onCircle(i, 4, 0.5);
    holes += cylinder(Axis::Z, Point(0.068 + 0.033 * c, 0.033 * s, 0.110), 0.0045, 0.04, 8);
    holes += cylinder(Axis::X, Point(0.14, 0.0415 * c, 0.0415 * s), 0.0045, 0.06, 8);
  }
  return holes;
}

Mesh terminalBox() {
  Mesh mesh = placed(extrusion(roundedRectangle(0.072, 0.062, 0.008, 6), 0.045, 0.103), Axis::Z, Point(-0.09, 0, 0));
  unite(mesh, cylinder(Axis::Y, Point(-0.09, 0.025, 0.089), 0.0095, 0.027, 24));
  return mesh;
}

Mesh foot(double x) {
  const Outline outline = roundedRectangle(0.05, 0.15, 0.01, 6);
  Mesh mesh = placed(extrusion(outline, kFootBottom, kFootBottom + 0.012), Axis::Z, Point(x, 0, 0));
  for (const double y : {-0.062, 0.062}) subtract(mesh, cylinder(Axis::Z, Point(x, y, -0.13), 0.0055, 0.04, 24));
  unite(mesh, box(Point(x - 0.009, -0.046, kFootBottom + 0.007), Point(x + 0.009, 0.046, -0.052)));
  return mesh;
}

Mesh pump() {
  Mesh mesh = pumpHousing();
  unite(mesh, motorFins());
  unite(mesh, flangeBolts());
  unite(mesh, dischargePort());
  subtract(mesh, portHoles());
  unite(mesh, terminalBox());
  for (const double x : kFootX) unite(mesh, foot(x));
  return mesh;
}

// The frame: solids bolted together -------------------------------------------------------------------------------

/// A square profile with a slot in each side, cut to `length` less the joints at both ends.
Mesh rail(Axis axis, const Point& from, double length, double edge = kRail) {
  const double h = edge / 2, chamfer = edge * 0.06, mouth = edge * 0.11, depth = edge * 0.2;
  Outline side{{h, chamfer - h}, {h, -mouth}, {h - depth, -mouth}, {h - depth, mouth}, {h, mouth}, {h, h - chamfer}};
  Outline outline;
  for (int turn = 0; turn < 4; ++turn) {
    for (auto& [x, y] : side) {
      outline.push_back({x, y});
      x = -std::exchange(y, x);
    }
  }
  const int pieces = static_cast<int>(std::ceil(length / kPiece));
  return placed(extrusion(outline, kJoint, length - kJoint, pieces), axis, from);
}

Mesh skeleton() {
  Mesh frame;
  for (const double x : {-0.58, 0.58}) {
    for (const double y : {-0.38, 0.38}) {
      frame += rail(Axis::Z, Point(x, y, 0.015), 0.885 + kJoint, kPost);
      frame += cylinder(Axis::Z, Point(x, y, 0), 0.0195, 0.015, 24);
    }
    for (const double z : {0.04, 0.195, 0.345, 0.495, 0.645, 0.875}) frame += rail(Axis::Y, Point(x, -0.36, z), 0.72);
  }
  for (const double z : {0.04, 0.645, 0.875}) {
    for (const double y : {-0.38, 0.38}) frame += rail(Axis::X, Point(-0.56, y, z), 1.12);
  }
  frame += rail(Axis::X, Point(-0.56, 0.38, 0.195), 1.12);
  frame += rail(Axis::X, Point(-0.56, -0.38, 0.242), 1.12);
  const double left = kOpeningX - kOpeningWidth / 2 - kPost, right = kOpeningX + kOpeningWidth / 2;
  for (const double x : {left, right}) frame += rail(Axis::Z, Point(x + kPost / 2, -0.38, 0.26), 0.367, kPost);
  for (const double z : {0.372, 0.498}) frame += rail(Axis::X, Point(-0.56, -0.38, z), left + 0.56);
  return frame;
}

/// Deck with drain holes, shelf, and a rear panel with louvres.
Mesh plates() {
  Mesh mesh = box(Point(-0.5598, -0.3598, kDeckTop - 0.012), Point(0.5598, 0.3598, kDeckTop));
  mesh += box(Point(-0.5598, -0.3598, kShelfTop - 0.012), Point(0.5598, 0.3598, kShelfTop));
  mesh += box(Point(-0.5598, 0.385, 0.06), Point(0.5598, 0.391, 0.85));
  Mesh holes;
  for (int i = 0; i < 8; ++i) {
    for (const double y : {-0.3, 0.22}) holes += cylinder(Axis::Z, Point(0.08 + 0.055 * i, y, 0.15), 0.012, 0.1, 12);
  }
  for (int i = 0; i < 10; ++i) {
    holes += boxAt(Point(0.3, 0.388, 0.29 + 0.032 * i), 0.36, 0.05, 0.011);
    holes += boxAt(Point(-0.3, 0.388, 0.691 + 0.014 * i), 0.36, 0.05, 0.006);
  }
  subtract(mesh, holes);
  return mesh;
}

/// A pad with lips on both sides and a stop at the outer end: the pump has to be lifted off.
Mesh seatPad(double footX) {
  const double x = kSeatX + footX, stop = x + (footX < 0 ? -0.0385 : 0.0385);
  Mesh pad = box(Point(x - 0.035, -0.105, kDeckTop + kJoint), Point(x + 0.035, 0.105, kPadTop));
  Mesh lips = boxAt(Point(stop, 0, kPadTop + 0.001), 0.009, 0.09, 0.042);
  for (const double y : {-0.091, 0.091}) lips += boxAt(Point(x, y, kPadTop + 0.001), 0.06, 0.014, 0.042);
  unite(pad, lips);
  return pad;
}

/// A base on the plane z = 0 and fins along x.
Mesh heatSink(double width, double length, double height, int fins) {
  Outline comb{{-width / 2, 0}, {width / 2, 0}};
  const double pitch = width / (fins - 0.5);
  for (int i = fins - 1; i >= 0; --i) {
    const double x = -width / 2 + i * pitch;
    comb.insert(comb.end(), {{x + pitch / 2, height}, {x, height}});
    if (i > 0) comb.insert(comb.end(), {{x, 0.012}, {x - pitch / 2, 0.012}});
  }
  return placed(extrusion(comb, -length / 2, length / 2), Axis::X, CGAL::ORIGIN);
}

Mesh capacitor(const Point& at, double r, double height) {
  const Outline profile{{kJoint, r - 0.003}, {0.004, r}, {height - 0.004, r}, {height, r - 0.004}};
  Mesh can = revolution(profile, 24);
  for (const double x : {-0.012, 0.012}) unite(can, cylinder(Axis::Z, Point(x, 0, height - 0.01), 0.005, 0.022, 8));
  return placed(can, Axis::Z, at);
}

/// A rectifier behind the seat, capacitors at the rear right and on the shelf, inverters on the shelf.
Mesh electronics() {
  Mesh mesh = heatSink(0.34, 0.44, 0.14, 11);
  pmp::transform(Transform(1, 0, 0, -0.29, 0, 0, -1, 0.385 - kJoint, 0, 1, 0, 0.43), mesh);
  for (int i = 0; i < 5; ++i) mesh += capacitor(Point(0.12 + 0.085 * i, 0.315, kDeckTop), 0.032, 0.15);
  for (int i = 0; i < 6; ++i) {
    for (const double y : {-0.1, 0.1}) mesh += capacitor(Point(0.06 + 0.088 * i, y, kShelfTop), 0.036, 0.11);
  }
  for (const double x : {-0.4, -0.14}) {
    mesh += boxAt(Point(x, 0, kShelfTop + kJoint + 0.03), 0.2, 0.36, 0.06);
    mesh += placed(heatSink(0.34, 0.18, 0.1, 16), Axis::Z, Point(x, 0, kShelfTop + 2 * kJoint + 0.06));
  }
  return mesh;
}

Mesh frame() {
  Mesh mesh = skeleton();
  for (const double x : kFootX) mesh += seatPad(x);
  mesh += plates();
  mesh += electronics();
  return mesh;
}

// Obstacles -------------------------------------------------------------------------------------------------------

/// A window with rounded corners through the plate of which `at` is a point.
Mesh window(Axis normal, const Point& at, double width, double height) {
  return placed(extrusion(roundedRectangle(width, height, 0.02, 3), -0.02, 0.02), normal, at);
}

/// A plate with windows, a foot, gussets, and the wing that the pump turns beside.
Mesh bracket() {
  constexpr double kLow = kDeckTop + 0.0015, kLeft = -0.45, kRight = 0.03;
  Mesh mesh = box(Point(kLeft, -0.155, kLow), Point(kRight, -0.147, 0.6));
  Mesh windows, holes;
  for (int i = 0; i < 3; ++i) {
    for (const double z : {0.315, 0.485}) windows += window(Axis::Y, Point(-0.37 + 0.16 * i, -0.15, z), 0.11, 0.09);
  }
  subtract(mesh, windows);
  Mesh base = box(Point(kLeft + 0.001, -0.24, kLow + 0.0005), Point(kRight - 0.001, -0.151, kLow + 0.009));
  for (int i = 0; i < 6; ++i) holes += cylinder(Axis::Z, Point(-0.42 + 0.08 * i, -0.215, 0.1), 0.006, 0.2, 12);
  subtract(base, holes);
  unite(mesh, base);
  Mesh ribs = box(Point(kRight - 0.0085, -0.30, kLow + 0.001), Point(kRight - 0.0005, -0.149, 0.595));
  subtract(ribs, window(Axis::X, Point(kRight, -0.23, 0.4), 0.09, 0.25));
  const Outline gusset{{-0.151, kLow + 0.005}, {-0.151, 0.45}, {-0.235, kLow + 0.005}};
  for (const double x : {-0.445, -0.29, -0.13}) ribs += placed(extrusion(gusset, -0.003, 0.003), Axis::X, {x, 0, 0});
  unite(mesh, ribs);
  return mesh;
}

Mesh pipes() {
  Mesh discharge = tube({{-0.52, 0, 0.204}, {-0.52, 0, 0.568}, {0.02, 0, 0.568}, {0.02, 0, 0.638}}, 0.05, 0.022, 24);
  for (const double z : {0.215, 0.40}) unite(discharge, cylinder(Axis::Z, Point(-0.52, 0, z), 0.032, 0.014, 20));
  Mesh coolant =
      tube({{-0.5, -0.33, 0.204}, {-0.5, -0.33, 0.558}, {0.5, -0.33, 0.558}, {0.5, -0.33, 0.638}}, 0.05, 0.018, 24);
  for (const double x : {-0.2, 0.43}) unite(coolant, cylinder(Axis::X, Point(x, -0.33, 0.558), 0.028, 0.014, 20));
  discharge += coolant;
  return discharge;
}

Mesh cables() {
  Mesh mesh = tube({{-0.4, 0.2, 0.638}, {-0.4, 0.19, 0.59}, {-0.37, 0.135, 0.62}, {-0.37, 0.135, 0.5755}}, 0.02, 0.006,
                   16);  // of the plug
  mesh += tube({{0.04, 0.26, 0.205}, {0.04, 0.26, 0.43}, {0.05, 0.2, 0.43}, {0.05, 0.2, 0.3555}}, 0.03, 0.016, 24);
  for (int i = 0; i < 3; ++i) {
    const double y = 0.16 - 0.05 * i;
    mesh += tube({{0.53, y, 0.637}, {0.52, y, 0.5}, {0.48, y - 0.02, 0.4}, {0.52, y - 0.03, 0.205}}, 0.06, 0.008, 16);
  }
  return mesh;
}

/// The motor's plug, with its contacts down.
Mesh plug() {
  Mesh mesh = extrusion(roundedRectangle(0.05, 0.036, 0.006, 6), -0.02, 0.02);
  Mesh ends = cylinder(Axis::Z, Point(0, 0, 0.015), 0.011, 0.02, 24);
  for (const double x : {-0.015, 0.0, 0.015}) {
    for (const double y : {-0.007, 0.007}) ends += cylinder(Axis::Z, Point(x, y, -0.03), 0.0025, 0.015, 12);
  }
  unite(mesh, ends);
  return mesh;
}

/// The suction hose's coupling: a ring with three lugs.
Mesh coupling() {
  const Outline profile{{0.045, 0.018},  {0.020, 0.022},  {0.018, 0.034},  {0.016, 0.036},
                        {-0.018, 0.036}, {-0.020, 0.034}, {-0.020, 0.022}, {-0.005, 0.020}};
  Mesh mesh = revolution(profile, 48), lugs;
  for (int i = 0; i < 3; ++i) {
    const auto [c, s] = onCircle(i, 3, 0.25);
    lugs += cylinder(Axis::Z, Point(0.036 * c, 0.036 * s, -0.012), 0.006, 0.024, 16);
  }
  unite(mesh, lugs);
  return mesh;
}

// Files -----------------------------------------------------------------------------------------------------------

std::string pose(const Point& at, const std::string& orientation = "0, 0, 0, 1") {
  return R"({"position": [)" + numbers(at, ", ") + R"(], "orientation": [)" + orientation + "]}";
}

/// A part of the scenario; its mesh has the part's name.
struct Part {
  std::string name;
  Mesh (*make)();
  std::string mobility, colour;
  Point at = CGAL::ORIGIN;
};

void writeScenario(const std::string& path, const std::vector<Part>& parts, const std::string& name,
                   const std::string& description, const std::string& start, const std::string& goal) {
  std::string assets, bodies;
  for (const Part& part : parts) {
    assets += R"({"id": ")" + part.name + R"(", "path": ")" + part.name + R"(.obj", "unit": 1, "up_axis": "z"}, )";
    bodies += (bodies.empty() ? R"({"id": ")" : R"(, {"id": ")") + part.name + R"(", "name": ")" + part.name +
              R"(", "mobility": ")" + part.mobility + R"(", "geometry": {"mesh": ")" + part.name + R"("}, "pose": )" +
              pose(part.at) + R"(, "colour": [)" + part.colour + "]}";
  }
  writeFile(path, R"({"format": "glissade-scenario", "version": 1, "name": ")" + name + R"(", "description": ")" +
                      description + R"(", "assets": [)" + assets +
                      R"({"id": "pump", "path": "pump.obj", "unit": 1, "up_axis": "z"}], "bodies": [)" + bodies +
                      R"(], "object": {"id": "pump", "name": "pump", "geometry": {"mesh": "pump"}, )" +
                      R"("colour": [0.30, 0.62, 0.42]}, "start": )" + start + R"(, "goal": )" + goal +
                      R"(, "workspace": {"min": [-0.35, -0.75, 0.3], "max": [0.4, 0.15, 0.5]}, "way_points": [], )" +
                      R"("planner": "gts", "parameters": {}, "seed": 1})" + "\n");
}

void generate(const std::string& folder) {
  const std::vector<Part> parts{{"frame", frame, "static", "0.62, 0.65, 0.70"},
                                {"bracket", bracket, "static", "0.85, 0.55, 0.20"},
                                {"pipes", pipes, "static", "0.35, 0.50, 0.72"},
                                {"cables", cables, "static", "0.22, 0.22, 0.24"},
                                {"plug", plug, "mobile", "0.80, 0.68, 0.45", Point(-0.37, 0.135, 0.54)},
                                {"coupling", coupling, "mobile", "0.80, 0.68, 0.45", Point(0.05, 0.2, 0.31)}};
  for (const Part& part : parts) writeObj(folder + "/" + part.name + ".obj", part.make());
  writeObj(folder + "/pump.obj", pump());
  const std::string mounted = pose(Point(kSeatX, 0, kPadTop + kSeatGap - kFootBottom));
  const std::string outside = pose(Point(kOpeningX, -0.66, 0.39), "0, 0, -0.7071067811865476, 0.7071067811865476");
  const std::string where = "the power-electronics frame, in the spirit of figure 16 of Cailhol et al. 2019: ";
  writeScenario(folder + "/unmount.json", parts, "Pump, unmounting",
                "The pump leaves its seat in " + where +
                    "lifted, shifted, turned beside the bracket and drawn out between the front rails.",
                mounted, outside);
  writeScenario(folder + "/mount.json", parts, "Pump, mounting",
                "The pump is brought to its seat in " + where +
                    "in between the front rails, turned beside the bracket, shifted and lowered.",
                outside, mounted);
}

}  // namespace
}  // namespace glissade::sample

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "Usage: generate FOLDER\n";
    return 2;
  }
  try {
    glissade::sample::generate(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
