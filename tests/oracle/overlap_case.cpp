#include "tests/oracle/overlap_case.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Trsf.hxx>
#include <random>
#include <stdexcept>

namespace glissade::oracle {

struct OverlapCase::Solids {
  TopoDS_Shape object;
  TopoDS_Shape block;
};

namespace {

constexpr Direction kUp{0.0, 0.0, 1.0};
constexpr Direction kDown{0.0, 0.0, -1.0};
constexpr Direction kRight{1.0, 0.0, 0.0};
constexpr Direction kLeft{-1.0, 0.0, 0.0};
constexpr Direction kFront{0.0, -1.0, 0.0};
constexpr Direction kBack{0.0, 1.0, 0.0};

/// A box between two opposite corners.
TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

/// A cylinder about the z-axis.
TopoDS_Shape rod(double radius, double z0, double z1) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.0, 0.0, z0), gp_Dir(0, 0, 1)), radius, z1 - z0).Shape();
}

TopoDS_Shape joined(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }
TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }

class CaseMaker {
 public:
  CaseMaker(std::uint64_t seed, std::uint64_t number) : number_(number) {
    std::seed_seq words{seed, number, std::uint64_t{0x0e71}};
    random_.seed(words);
  }

  OverlapCase make() {
    switch (number_ % 8) {
      case 0: return slab(false);
      case 1: return shaft();
      case 2: return slab(true);
      case 3: return rodThroughPlate();
      case 4: return barThroughFrame();
      case 5: return discInRod();
      case 6: return endInBlock();
      default: return sunkFlange();
    }
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool is(double share) { return between(0.0, 1.0) < share; }

  static OverlapCase caseOf(std::string name, const TopoDS_Shape& object, const TopoDS_Shape& block) {
    OverlapCase made;
    made.name = std::move(name);
    made.solids = std::make_shared<const OverlapCase::Solids>(OverlapCase::Solids{object, block});
    return made;
  }

  /// The depth of a boss's overlap. `accepts`: the depth has to be accepted.
  double overlapOf(OverlapCase& made, bool accepts) {
    const double depth = accepts ? between(1.1, 1.6) : between(0.2, 0.95);
    made.accepted = accepts ? depth + 0.05 : 0.0;
    return depth;
  }

  /// A slab under a boss, and a lip in its plane over the way out. The top may be a part of a cylinder, written as a
  /// spline.
  OverlapCase slab(bool isSpline) {
    const double width = between(20.0, 40.0);
    const double length = between(60.0, 100.0);
    const double height = between(10.0, 14.0);
    const bool hasLip = is(0.7);
    OverlapCase made;
    const double depth = overlapOf(made, !isSpline && is(0.3));
    const double lip = std::max(0.15, depth * between(0.3, 0.95));
    TopoDS_Shape object = box(0.0, -0.5 * width, 0.0, length, 0.5 * width, height);
    const auto above = [&](double x0, double x1, double halfWidth, double reach) {
      if (!isSpline) return box(x0, -halfWidth, height - reach, x1, halfWidth, height + 10.0);
      return cut(box(x0, -halfWidth, 0.0, x1, halfWidth, height + 20.0), barrel(height - reach, x0 - 1.0, x1 + 1.0));
    };
    if (isSpline) {
      object =
          BRepBuilderAPI_NurbsConvert(BRepAlgoAPI_Common(object, barrel(height, -1.0, length + 1.0)).Shape()).Shape();
    }
    const double at = between(0.05, 0.2) * length;
    const double size = between(3.0, 6.0);
    TopoDS_Shape block = cut(box(-10.0, -0.5 * width - 10.0, -8.0, length + 30.0, 0.5 * width + 10.0, height + 8.0),
                             box(-0.05, -0.5 * width - 0.05, 0.0, length + 40.0, 0.5 * width + 0.05, height + 2.0));
    block = joined(block, above(at, at + size, 0.5 * size, depth));
    if (hasLip) block = joined(block, above(length + 5.0, length + 12.0, between(0.3, 0.5) * width, lip));
    const double accepted = made.accepted;
    made = caseOf(std::string(isSpline ? "spline" : "plane") + (hasLip ? " under a boss and a lip" : " under a boss"),
                  object, block);
    made.accepted = accepted;
    (hasLip ? made.blocked : made.free).push_back(kRight);
    return made;
  }

  /// A part of a cylinder of 60 mm radius about an axis along x.
  static TopoDS_Shape barrel(double top, double x0, double x1) {
    constexpr double kRadius = 60.0;
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x0, 0.0, top - kRadius), gp_Dir(1, 0, 0)), kRadius, x1 - x0).Shape();
  }

  /// A shaft in a bore with a nib, and a lip on the other side of the bore.
  OverlapCase shaft() {
    const double radius = between(8.0, 15.0);
    const double length = between(40.0, 70.0);
    const bool hasLip = is(0.7);
    OverlapCase made;
    const double depth = overlapOf(made, is(0.3));
    const double lip = depth * between(0.4, 0.95);
    const double nib = between(2.0, 4.0);
    TopoDS_Shape block = cut(box(-radius - 12.0, -radius - 12.0, -8.0, radius + 12.0, radius + 12.0, length + 20.0),
                             rod(radius + 0.1, 0.0, length + 30.0));
    block = joined(block, box(radius - depth, -0.5 * nib, 5.0, radius + 5.0, 0.5 * nib, 5.0 + nib));
    if (hasLip) {
      block = joined(block, box(-radius - 5.0, -0.5 * nib, length + 5.0, -radius + lip, 0.5 * nib, length + 5.0 + nib));
    }
    const double accepted = made.accepted;
    made = caseOf(hasLip ? "shaft between a nib and a lip" : "shaft beside a nib", rod(radius, 0.0, length), block);
    made.accepted = accepted;
    made.cutsBlock = true;  // the shaft encloses the end of the nib: without a name the shaft gets a notch
    (hasLip ? made.blocked : made.free).push_back(kUp);
    return made;
  }

  /// A small plate, without a hole, on a long rod.
  OverlapCase rodThroughPlate() {
    const double radius = between(2.0, 6.0);
    const double half = radius * between(2.0, 5.0);
    const double thickness = between(2.0, 8.0);
    const double reach = between(100.0, 300.0);
    const int heads = static_cast<int>(between(0.0, 3.0));
    TopoDS_Shape block = is(0.5) ? rod(radius, -reach, reach) : box(-radius, -radius, -reach, radius, radius, reach);
    if (heads > 0) block = joined(block, rod(1.5 * radius, thickness + 10.0, thickness + 20.0));
    if (heads > 1) block = joined(block, rod(1.5 * radius, -20.0, -10.0));
    const double shift = between(-0.3, 0.3) * (half - radius);
    OverlapCase made = caseOf("plate on a rod with " + std::to_string(heads) + " heads",
                              box(shift - half, -half, 0.0, shift + half, half, thickness), block);
    made.accepted = 0.5 * thickness + radius;
    made.blocked = {kLeft, kRight, kFront, kBack};
    (heads > 0 ? made.blocked : made.free).push_back(kUp);
    (heads > 1 ? made.blocked : made.free).push_back(kDown);
    return made;
  }

  /// A bar through one limb of a closed frame.
  OverlapCase barThroughFrame() {
    const double limb = between(3.0, 6.0);
    const double bar = limb * between(1.5, 3.0);
    const double inner = between(25.0, 40.0);
    const TopoDS_Shape frame =
        cut(box(-inner - limb, -0.5 * limb, -inner - limb, inner + limb, 0.5 * limb, inner + limb),
            box(-inner, -limb, -inner, inner, limb, inner));
    const double middle = inner + 0.5 * limb;
    OverlapCase made = caseOf("bar through a limb of a frame",
                              box(middle - 0.5 * bar, -20.0, -0.5 * bar, middle + 0.5 * bar, 20.0, 0.5 * bar), frame);
    made.accepted = 2.0 * bar;
    made.blocked = {kLeft, kRight, kFront, kBack, kUp, kDown};
    return made;
  }

  /// A disc with the outline of the rod around it.
  OverlapCase discInRod() {
    const double radius = between(4.0, 10.0);
    const double thickness = between(2.0, 8.0);
    const double reach = between(50.0, 150.0);
    const bool isRound = is(0.5);
    OverlapCase made =
        caseOf("disc in a rod of its outline",
               isRound ? rod(radius, 0.0, thickness) : box(-radius, -radius, 0.0, radius, radius, thickness),
               isRound ? rod(radius, -reach, reach) : box(-radius, -radius, -reach, radius, radius, reach));
    made.accepted = 2.0 * radius;
    made.blocked = {kLeft, kRight, kFront, kBack, kUp, kDown};
    return made;
  }

  /// The end of a rod in a block, without a hole.
  OverlapCase endInBlock() {
    const double radius = between(3.0, 8.0);
    const double depth = radius * between(1.5, 4.0);
    const double half = radius * between(2.5, 5.0);
    OverlapCase made = caseOf("end of a rod in a block", rod(radius, -depth, between(60.0, 150.0)),
                              box(-half, -half, -depth - half, half, half, 0.0));
    made.accepted = depth + radius;
    made.blocked = {kLeft, kRight, kFront, kBack, kDown};
    made.free = {kUp};
    return made;
  }

  /// A flange that is drawn too low. The plate has a bore below it.
  OverlapCase sunkFlange() {
    const double radius = between(20.0, 60.0);
    const double depth = between(1.1, 3.0);
    const double thickness = between(4.0, 9.0);
    const TopoDS_Shape plate = cut(box(-1.5 * radius, -1.5 * radius, -thickness, 1.5 * radius, 1.5 * radius, 0.0),
                                   rod(between(0.1, 0.5) * radius, -thickness - 1.0, 1.0));
    OverlapCase made = caseOf("sunk flange", rod(radius, -depth, between(4.0, 10.0)), plate);
    made.accepted = depth + 0.01;
    made.blocked = {kDown};
    made.free = {kUp};
    return made;
  }

  std::uint64_t number_;
  std::mt19937_64 random_;
};

void write(const TopoDS_Shape& shape, const std::string& file) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // prevents statistics on the standard output
  STEPControl_Writer writer;
  const bool written =
      writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone && writer.Write(file.c_str()) == IFSelect_RetDone;
  if (!written) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace

OverlapCase overlapCase(std::uint64_t seed, std::uint64_t number) { return CaseMaker(seed, number).make(); }

void writeCase(const OverlapCase& pair, const std::string& object, const std::string& block) {
  write(pair.solids->object, object);
  write(pair.solids->block, block);
}

double sharedVolume(const OverlapCase& pair, const Direction& direction, double way) {
  gp_Trsf moved;
  moved.SetTranslation(way * gp_Vec(direction[0], direction[1], direction[2]));
  BRepAlgoAPI_Common common(pair.solids->object.Moved(TopLoc_Location(moved)), pair.solids->block);
  if (!common.IsDone()) throw std::runtime_error("the common volume was not found");
  GProp_GProps properties;
  BRepGProp::VolumeProperties(common.Shape(), properties);
  return properties.Mass();
}

}  // namespace glissade::oracle
