// Writes the STEP files that tests read into a folder: usage: make_step_files FOLDER
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <XCAFDoc_Area.hxx>
#include <XCAFDoc_Centroid.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFDoc_Volume.hxx>
#include <array>
#include <cmath>
#include <fstream>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt2d.hxx>
#include <iostream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "tests/step_files/countersunk_ring.h"

namespace {

constexpr double kQuarterTurn = 1.5707963267948966;

TopLoc_Location at(double x, double y, double z) {
  gp_Trsf place;
  place.SetTranslation(gp_Vec(x, y, z));
  return place;
}

/// A location with a quarter turn about the x-axis, at this position.
TopLoc_Location turnedAt(double x, double y, double z) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(), gp_Dir(1, 0, 0)), kQuarterTurn);
  return at(x, y, z) * TopLoc_Location(turn);
}

TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(gp_Pnt(-x / 2, -y / 2, -z / 2), x, y, z); }
/// A cylinder along z with its middle at the origin.
TopoDS_Shape cylinder(double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -length / 2), gp_Dir(0, 0, 1)), radius, length);
}
TopoDS_Shape plateWithHole() { return BRepAlgoAPI_Cut(box(100, 60, 10), cylinder(8.5, 20)); }
/// A block and a post, with a ball taken out of the block's corner.
TopoDS_Shape booleanResult() {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(30, 20, 10), 12.0);
  const TopoDS_Shape block = BRepAlgoAPI_Cut(box(60, 40, 20), ball);
  return BRepAlgoAPI_Fuse(block, cylinder(9, 70));
}
TopoDS_Shape twoSolids() {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, box(10, 10, 10));
  builder.Add(both, box(20, 20, 20).Moved(at(100, 0, 0)));
  return both;
}

TopoDS_Shape coneAt(const gp_Ax2& axes) { return BRepPrimAPI_MakeCone(axes, 12.0, 4.0, 30.0); }
/// A solid for each kind of surface, none of them along the axes. The last solid is an ellipsoid.
TopoDS_Shape kindsOfFaces() {
  const gp_Ax2 axes(gp_Pnt(5, -3, 7), gp_Dir(1, 2, 3));
  gp_GTrsf stretched;
  stretched.SetVectorialPart(gp_Mat(30, 0, 0, 0, 20, 0, 0, 0, 10));
  stretched.SetTranslationPart(gp_XYZ(1, 2, 3));
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, BRepPrimAPI_MakeCylinder(axes, 10.0, 40.0).Shape());
  builder.Add(all, coneAt(axes));
  builder.Add(all, BRepPrimAPI_MakeSphere(axes, 15.0).Shape());
  builder.Add(all, BRepPrimAPI_MakeTorus(axes, 20.0, 6.0).Shape());
  builder.Add(all, BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(1.0).Shape(), stretched).Shape());
  return all;
}

/// A disc with a hole that leaves 0.001 mm of its rim, so that the polygons of both circles cross.
TopoDS_Shape discWithThinRim() {
  constexpr double kAngle = 1.0;
  constexpr double kDistance = 17.999;
  const gp_Dir outwards(std::cos(kAngle), std::sin(kAngle), 0);
  const gp_Pnt middle(kDistance * std::cos(kAngle), kDistance * std::sin(kAngle), -1);
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(20.0, 2.0).Shape(),
                         BRepPrimAPI_MakeCylinder(gp_Ax2(middle, gp_Dir(0, 0, 1), outwards), 2.0, 4.0).Shape());
}

/// The edge that is a line in the parameters of the wall: a helix, or a line along it.
TopoDS_Edge edgeOn(const Handle(Geom_CylindricalSurface) & wall, const TopoDS_Vertex& from, double fromAngle,
                   const TopoDS_Vertex& to, double toAngle) {
  const gp_Pnt2d begin(fromAngle, BRep_Tool::Pnt(from).Z());
  const gp_Pnt2d end(toAngle, BRep_Tool::Pnt(to).Z());
  const Handle(Geom2d_Line) line = new Geom2d_Line(begin, gp_Dir2d(gp_Vec2d(begin, end)));
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, wall, from, to, 0.0, begin.Distance(end));
  BRepLib::BuildCurves3d(edge);
  return edge;
}

TopoDS_Face faceOn(const Handle(Geom_CylindricalSurface) & wall, const std::array<TopoDS_Edge, 3>& edges) {
  BRepBuilderAPI_MakeWire wire;
  for (const TopoDS_Edge& edge : edges) wire.Add(edge);
  TopoDS_Face face;
  BRep_Builder builder;
  builder.MakeFace(face, wall, 1e-7);
  builder.Add(face, wire.Wire());
  return face;
}

/// The crest of a thread as CAD systems write it: a band between two helices, as two faces that share a line. The
/// boundary of each goes around the cylinder and encloses nothing alone.
TopoDS_Shape woundBand() {
  const Handle(Geom_CylindricalSurface) wall = new Geom_CylindricalSurface(gp_Ax3(), 5.0);
  const auto vertex = [](double z) -> TopoDS_Vertex { return BRepBuilderAPI_MakeVertex(gp_Pnt(5, 0, z)); };
  const TopoDS_Vertex upper = vertex(1.0);
  const TopoDS_Vertex upperEnd = vertex(0.0);
  const TopoDS_Vertex lower = vertex(0.75);
  const TopoDS_Vertex lowerEnd = vertex(-0.25);
  constexpr double kTurn = 2 * std::numbers::pi;
  const TopoDS_Edge shared = edgeOn(wall, upperEnd, kTurn, lower, kTurn);
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, faceOn(wall, {TopoDS::Edge(edgeOn(wall, upper, 0, upperEnd, kTurn).Reversed()),
                                   edgeOn(wall, upper, 0, lower, 0), TopoDS::Edge(shared.Reversed())}));
  builder.Add(shell, faceOn(wall, {edgeOn(wall, lower, 0, lowerEnd, kTurn),
                                   edgeOn(wall, lowerEnd, kTurn, upperEnd, kTurn), shared}));
  return shell;
}

/// A roller: the face between its two ends is a part of a torus that meets itself.
TopoDS_Shape barrel() {
  constexpr double kCircle = 34.5;
  constexpr double kTube = 41.0;
  constexpr double kAngle = 0.15;  // of the tube, from the middle to an end
  const auto disc = [](double side) {
    const gp_Ax2 axes(gp_Pnt(0, 0, side * kTube * std::sin(kAngle)), gp_Dir(0, 0, side));
    const TopoDS_Edge rim = BRepBuilderAPI_MakeEdge(gp_Circ(axes, kTube * std::cos(kAngle) - kCircle));
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(axes)), BRepBuilderAPI_MakeWire(rim).Wire()).Face();
  };
  constexpr double kHalf = std::numbers::pi;
  BRepBuilderAPI_Sewing sewing(1e-4);
  sewing.Add(BRepBuilderAPI_MakeFace(new Geom_ToroidalSurface(gp_Ax3(), kCircle, kTube), 0.0, 2.0 * kHalf,
                                     kHalf - kAngle, kHalf + kAngle, 1e-7));
  for (const double side : {-1.0, 1.0}) sewing.Add(disc(side));
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
}

/// A document of products, written as one STEP file.
class Product {
 public:
  Product() : document_(new TDocStd_Document("XmlXCAF")) {
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
    colours_ = XCAFDoc_DocumentTool::ColorTool(document_->Main());
  }

  TDF_Label part(const char* name, const TopoDS_Shape& shape) {
    const TDF_Label label = shapes_->AddShape(shape, false);
    TDataStd_Name::Set(label, TCollection_ExtendedString(name, true));
    return label;
  }
  TDF_Label part(const char* name, const TopoDS_Shape& shape, double red, double green, double blue) {
    const TDF_Label label = part(name, shape);
    colours_->SetColor(label, Quantity_Color(red, green, blue, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    return label;
  }
  TDF_Label assembly(const char* name) {
    const TDF_Label label = shapes_->NewShape();
    TDataStd_Name::Set(label, TCollection_ExtendedString(name, true));
    return label;
  }
  void put(const TDF_Label& part, const TDF_Label& assembly, const TopLoc_Location& place) {
    shapes_->AddComponent(assembly, part, place);
  }

  /// `partFiles`: the beginning of the names of the files that hold one part each; null: one file holds all parts.
  void write(const std::string& file, const char* unit = "MM", const char* partFiles = nullptr) {
    shapes_->UpdateAssemblies();
    STEPCAFControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", unit);  // has effect on writers that are made later
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    writer.SetPropsMode(true);
    if (!writer.Transfer(document_, STEPControl_AsIs, partFiles) || writer.Write(file.c_str()) != IFSelect_RetDone) {
      throw std::string("cannot write " + file);
    }
  }

 private:
  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
};

void writePart(const std::string& file, const char* name, const TopoDS_Shape& shape, const char* unit = "MM") {
  Product product;
  product.part(name, shape);
  product.write(file, unit);
}

/// Writes the box's file with other faces.
void writeCountersunkRing(const std::string& box, const std::string& file) {
  std::ifstream in(box, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string shell = "CLOSED_SHELL('',(";
  const std::size_t faces = text.find(shell) + shell.size();
  text.replace(faces, text.find(')', faces) - faces, kCountersunkRingFaces);
  text.insert(text.rfind("ENDSEC;"), kCountersunkRing);
  if (!(std::ofstream(file, std::ios::binary) << text)) throw std::string("cannot write " + file);
}

/// A plate with a hole and two pins (one in the hole, one beside it), and a pump of two parts.
void writeAssembly(const std::string& file) {
  Product product;
  const TDF_Label plate = product.part("plate", plateWithHole(), 0.8, 0.2, 0.1);
  const TDF_Label pin = product.part("pin", cylinder(8, 40), 0.1, 0.4, 0.9);
  const TDF_Label housing = product.part("housing", box(40, 40, 40));
  const TDF_Label rotor = product.part("Läufer", cylinder(5, 30));
  const TDF_Label pump = product.assembly("pump");
  product.put(housing, pump, at(0, 0, 0));
  product.put(rotor, pump, turnedAt(0, -50, 0));
  const TDF_Label unit = product.assembly("unit");
  product.put(plate, unit, at(0, 0, 0));
  product.put(pin, unit, at(0, 0, 10));
  product.put(pin, unit, turnedAt(0, 200, 8));
  product.put(pump, unit, at(300, 0, 20));
  product.write(file);
}

/// A cylinder with its axis along z, from `bottom` up.
TopoDS_Shape shaft(double x, double y, double bottom, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, bottom), gp_Dir(0, 0, 1)), radius, length);
}
TopoDS_Shape blockAt(double x, double y, double bottom, double width, double depth, double height) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x - width / 2, y - depth / 2, bottom), width, depth, height);
}

/// Parts with usual fits in their assembled poses: a bolt of its holes' radius through bracket, plate and nut; a screw
/// thicker than its tapped hole; a dowel thicker than its hole by a hundredth; a rod that is free in a wide hole; a
/// block 3 mm deep in the plate.
void writeFits(const std::string& file) {
  TopoDS_Shape plate = blockAt(0, 0, 0, 120, 60, 10);
  plate = BRepAlgoAPI_Cut(plate, shaft(-40, 0, -5, 4, 20));
  plate = BRepAlgoAPI_Cut(plate, shaft(-10, 0, -5, 2.1, 20));
  plate = BRepAlgoAPI_Cut(plate, shaft(15, 0, -5, 3, 20));
  plate = BRepAlgoAPI_Cut(plate, shaft(40, 15, -5, 5, 20));
  const TopoDS_Shape bracket = BRepAlgoAPI_Cut(blockAt(-40, 0, 10, 24, 40, 8), shaft(-40, 0, 5, 4, 20));
  const TopoDS_Shape bolt = BRepAlgoAPI_Fuse(shaft(-40, 0, -12, 4, 30), shaft(-40, 0, 18, 7, 5));
  const TopoDS_Shape nut = BRepAlgoAPI_Cut(blockAt(-40, 0, -7, 13, 13, 7), shaft(-40, 0, -10, 4, 20));
  const TopoDS_Shape screw = BRepAlgoAPI_Fuse(shaft(-10, 0, 2, 2.5, 10), shaft(-10, 0, 10, 5, 3));
  Product product;
  const TDF_Label unit = product.assembly("fits");
  const auto add = [&](const char* name, const TopoDS_Shape& shape) {
    product.put(product.part(name, shape), unit, at(0, 0, 0));
  };
  add("plate", plate);
  add("bracket", bracket);
  add("bolt", bolt);
  add("nut", nut);
  add("screw", screw);
  add("dowel", shaft(15, 0, -2, 3.01, 14));
  add("rod", shaft(40, 15, -20, 4.9, 60));
  add("block", blockAt(40, -18, 7, 10, 10, 12));
  product.write(file);
}

/// A large plate with holes of 8, 6.01, 12 and 20 mm radius. The first hole has a pin of its radius; the second a pin
/// of 6 mm that is written as B-splines and turned upside down; the third a pin that is 1.5 mm thinner. Beside the
/// plate, two rods of equal radius lie end to end.
void writeCloseFits(const std::string& file) {
  TopoDS_Shape plate = blockAt(0, 0, 0, 240, 100, 20);
  plate = BRepAlgoAPI_Cut(plate, shaft(-80, 0, -5, 8, 30));
  plate = BRepAlgoAPI_Cut(plate, shaft(-30, 0, -5, 6.01, 30));
  plate = BRepAlgoAPI_Cut(plate, shaft(20, 0, -5, 12, 30));
  plate = BRepAlgoAPI_Cut(plate, shaft(80, 0, -5, 20, 30));
  Product product;
  const TDF_Label unit = product.assembly("close");
  product.put(product.part("plate", plate), unit, at(0, 0, 0));
  product.put(product.part("pin", cylinder(8, 60)), unit, at(-80, 0, 10));
  product.put(product.part("spline", BRepBuilderAPI_NurbsConvert(cylinder(6, 60))), unit,
              turnedAt(-30, 0, 10) * turnedAt(0, 0, 0));
  product.put(product.part("loose", cylinder(10.5, 60)), unit, at(20, 0, 10));
  const TDF_Label rod = product.part("rod", cylinder(5, 100));
  product.put(rod, unit, at(0, 80.3, 0.1));
  product.put(rod, unit, at(0, 80.3, 100.1));
  product.write(file);
}

/// A screw along z whose head is a cone of 90 degrees, with its upper end at this height.
TopoDS_Shape countersunkScrew(double x, double top) {
  const TopoDS_Shape head = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, 0, top - 2), gp_Dir(0, 0, 1)), 2.0, 4.0, 2.0);
  return BRepAlgoAPI_Fuse(shaft(x, 0, top - 14, 2, 12), head);
}

TopoDS_Shape ballAt(double x, double radius) {
  return BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(x, 0, 60), gp_Dir(0, 0, 1)), radius);
}

/// A product with fits of round surfaces. Three screws are in countersinks of a plate that their shafts do not touch:
/// one seated, one 0.1 mm too deep, one 0.05 mm too high. Above them, balls are in a groove with the shape of a torus:
/// of its radius, and 0.05 mm smaller.
void writeRoundFits(const std::string& file) {
  TopoDS_Shape plate = blockAt(0, 0, 0, 80, 30, 6);
  for (const double x : {-25.0, 0.0, 25.0}) {
    plate = BRepAlgoAPI_Cut(plate, shaft(x, 0, -5, 2.5, 20));
    plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, 0, 4), gp_Dir(0, 0, 1)), 2.0, 4.0, 2.0));
  }
  const TopoDS_Shape race = BRepAlgoAPI_Cut(
      blockAt(0, 0, 54, 40, 40, 6), BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, 60), gp_Dir(0, 0, 1)), 10.0, 3.0));
  Product product;
  const TDF_Label unit = product.assembly("round");
  const auto add = [&](const char* name, const TopoDS_Shape& shape) {
    product.put(product.part(name, shape), unit, at(0, 0, 0));
  };
  add("plate", plate);
  add("seated", countersunkScrew(-25, 6.0));
  add("deep", countersunkScrew(0, 5.9));
  add("high", countersunkScrew(25, 6.05));
  add("race", race);
  add("ball", ballAt(10, 3.0));
  add("small", ballAt(-10, 2.95));
  product.write(file);
}

/// A hexagon about z, from `bottom` up; millimetres across the flats, and its height.
TopoDS_Shape hexagonAt(double bottom, double across = 16, double height = 8) {
  BRepBuilderAPI_MakePolygon outline;
  for (int corner = 0; corner < 6; ++corner) {
    const double angle = corner * std::numbers::pi / 3;
    const double radius = 0.5 * across / std::cos(std::numbers::pi / 6);
    outline.Add(gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), bottom));
  }
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()), gp_Vec(0, 0, height));
}

/// A bolt M5 through a plate, with a nut of 8 mm that has the hole for the tap, 4.2 mm. The shaft protrudes from the
/// nut.
void writeTappedNut(const std::string& file) {
  Product product;
  const TDF_Label unit = product.assembly("unit");
  const auto add = [&](const char* name, const TopoDS_Shape& shape) {
    product.put(product.part(name, shape), unit, at(0, 0, 0));
  };
  add("plate", BRepAlgoAPI_Cut(blockAt(0, 0, 0, 60, 60, 10), shaft(0, 0, -5, 2.5, 20)));
  add("ISO 4014 M5x25", BRepAlgoAPI_Fuse(shaft(0, 0, -15, 2.5, 25), hexagonAt(10, 8, 3.5)));
  add("ISO 4032 M5", BRepAlgoAPI_Cut(hexagonAt(-4, 8, 4), shaft(0, 0, -5, 2.1, 20)));
  product.write(file);
}

/// A bolt M10 through a plate, with a nut or without: all of their cylinders have 10 mm. `scale`: as in a file with
/// wrong units.
void writeBolt(const std::string& file, double scale, bool hasNut) {
  gp_Trsf larger;
  larger.SetScale(gp_Pnt(), scale);
  Product product;
  const TDF_Label unit = product.assembly("unit");
  const auto add = [&](const char* name, const TopoDS_Shape& shape) {
    product.put(product.part(name, BRepBuilderAPI_Transform(shape, larger, true)), unit, at(0, 0, 0));
  };
  add("plate", BRepAlgoAPI_Cut(blockAt(0, 0, 0, 60, 60, 10), shaft(0, 0, -5, 5, 20)));
  add("bolt", BRepAlgoAPI_Fuse(shaft(0, 0, -15, 5, 25), hexagonAt(10)));
  if (hasNut) add("nut", BRepAlgoAPI_Cut(hexagonAt(-8), shaft(0, 0, -10, 5, 20)));
  product.write(file);
}

/// A plate and a unit of two plates, with the validation properties that OpenCASCADE measures. The stated volume of the
/// plate is `share` of the true one, and its stated centroid deviates by `aside` mm.
void writeValidated(const std::string& file, double share, double aside) {
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(blockAt(5, 0, 0, 40, 30, 10), shaft(0, 5, -5, 6, 20));
  GProp_GProps volume;
  GProp_GProps area;
  BRepGProp::VolumeProperties(shape, volume);
  BRepGProp::SurfaceProperties(shape, area);
  Product product;
  const TDF_Label plate = product.part("plate", shape);
  XCAFDoc_Volume::Set(plate, share * volume.Mass());
  XCAFDoc_Area::Set(plate, area.Mass());
  XCAFDoc_Centroid::Set(plate, volume.CentreOfMass().Translated(gp_Vec(aside, 0, 0)));
  const TDF_Label both = product.assembly("both");
  product.put(plate, both, at(0, 0, 0));
  product.put(plate, both, turnedAt(100, 0, 0));
  XCAFDoc_Volume::Set(both, 2.0 * volume.Mass());
  product.write(file);
}

/// A plate, two pins, and a pump of two parts, each in its own file beside the product's file.
void writeSplit(const std::string& folder) {
  Product product;
  const TDF_Label plate = product.part("plate", plateWithHole());
  const TDF_Label pin = product.part("pin", cylinder(8, 40));
  const TDF_Label pump = product.assembly("pump");
  product.put(product.part("housing", box(40, 40, 40)), pump, at(0, 0, 0));
  product.put(product.part("rotor", cylinder(5, 30)), pump, turnedAt(0, -50, 0));
  const TDF_Label unit = product.assembly("unit");
  product.put(plate, unit, at(0, 0, 0));
  product.put(pin, unit, at(0, 0, 10));
  product.put(pin, unit, turnedAt(0, 200, 8));
  product.put(pump, unit, turnedAt(300, 0, 20));
  product.write(folder + "/split.step", "MM", "split-");
}

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

TopoDS_Shape sheetAt(double height, bool upwards = true) {
  const gp_Pln plane(gp_Pnt(0, 0, height), gp_Dir(0, 0, upwards ? 1 : -1));
  return BRepBuilderAPI_MakeFace(plane, -20.0, 20.0, -10.0, 10.0);
}

/// A rod with the surface of a cylinder beside it, as programs draw the cosmetic thread of a screw.
TopoDS_Shape rodWithSurface(double rod, double surface) {
  const Handle(Geom_CylindricalSurface) wall = new Geom_CylindricalSurface(gp_Ax3(), surface);
  return compoundOf({cylinder(rod, 40), BRepBuilderAPI_MakeFace(wall, 0.0, 2.0 * std::numbers::pi, -19.0, 5.0, 1e-7)});
}

/// Two rods: the surface of the one is inside it, that of the other is around it.
void writeCosmeticThreads(const std::string& file) {
  Product product;
  const TDF_Label both = product.assembly("rods");
  product.put(product.part("covered", rodWithSurface(5.0, 4.2)), both, at(0, 0, 0));
  product.put(product.part("covered", rodWithSurface(5.0, 4.2)), both, turnedAt(50, 0, 7));
  product.put(product.part("bare", rodWithSurface(5.0, 5.2)), both, at(100, 0, 0));
  product.write(file);
}

/// A solid made of the two sides of one sheet.
TopoDS_Shape flatSolid() {
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(sheetAt(200));
  sewing.Add(sheetAt(200, false));
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
}

/// Two sheets; a box beside three single edges; a solid of two sides of one sheet; the shell of a box.
void writeOddShapes(const std::string& file) {
  Product product;
  const TDF_Label odd = product.assembly("odd");
  const auto add = [&](const char* name, const TopoDS_Shape& shape) {
    product.put(product.part(name, shape), odd, at(0, 0, 0));
  };
  const auto edge = [](double x) { return BRepBuilderAPI_MakeEdge(gp_Pnt(x, 0, 60), gp_Pnt(x, 9, 60)).Shape(); };
  add("sheets", compoundOf({sheetAt(100), sheetAt(120)}));
  add("wired", compoundOf({box(10, 10, 10), edge(0), edge(1), edge(2)}));
  add("flat", flatSolid());
  add("shell", TopExp_Explorer(box(30, 30, 30), TopAbs_SHELL).Current());
  product.write(file);
}

/// A frame of two blocks that touch, placed twice, and a pad. The frame is one product of two solids.
void writeFrames(const std::string& file) {
  Product product;
  const TDF_Label frame =
      product.part("frame", compoundOf({blockAt(0, 0, 0, 60, 20, 10), blockAt(0, 0, 10, 20, 20, 30)}));
  const TDF_Label unit = product.assembly("frames");
  product.put(frame, unit, at(0, 0, 0));
  product.put(frame, unit, turnedAt(0, 100, 40));
  product.put(product.part("pad", box(10, 10, 4)), unit, at(25, 0, 12));
  product.write(file);
}

/// Writes shapes as IGES: as separate trimmed surfaces, or as solids.
void writeIges(const std::string& file, const std::vector<TopoDS_Shape>& shapes, bool asSolids,
               const char* unit = "MM") {
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit, asSolids ? 1 : 0);
  for (const TopoDS_Shape& shape : shapes) writer.AddShape(shape);
  writer.ComputeModel();
  if (!writer.Write(file.c_str())) throw std::string("cannot write " + file);
}

void writeBrep(const std::string& file, const TopoDS_Shape& shape) {
  if (!BRepTools::Write(shape, file.c_str())) throw std::string("cannot write " + file);
}

/// A plate with a pin in its hole, and a block beside them.
std::vector<TopoDS_Shape> plateAndPin() {
  return {plateWithHole(), cylinder(8, 40), box(30, 20, 10).Moved(at(100, 0, 0))};
}

void writeAll(const std::string& folder) {
  writePart(folder + "/box.step", "box", box(100, 50, 20));
  writePart(folder + "/large-box.step", "box", box(10000, 5000, 2000));
  writePart(folder + "/cylinder.STP", "cylinder", cylinder(10, 40));
  writePart(folder + "/ball.stp", "ball", BRepPrimAPI_MakeSphere(25.0));
  writePart(folder + "/plate.step", "plate", plateWithHole());
  writePart(folder + "/boolean.step", "boolean", booleanResult());
  writePart(folder + "/inch.step", "inch", box(50.8, 25.4, 25.4), "INCH");
  writePart(folder + "/two-solids.step", "two", twoSolids());
  writePart(folder + "/surface.step", "sheet", BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 100.0, 0.0, 50.0));
  writePart(folder + "/edge.step", "edge", BRepBuilderAPI_MakeEdge(gp_Pnt(), gp_Pnt(10, 0, 0)));
  writePart(folder + "/cone.step", "cone", coneAt(gp_Ax2(gp_Pnt(5, -3, 7), gp_Dir(1, 2, 3))));
  writePart(folder + "/faces.step", "faces", kindsOfFaces());
  writePart(folder + "/barrel.step", "barrel", barrel());
  writePart(folder + "/thin-rim.step", "disc", discWithThinRim());
  writeCountersunkRing(folder + "/box.step", folder + "/countersunk-ring.step");
  writePart(folder + "/wound-band.step", "band", woundBand());
  writeAssembly(folder + "/unit.step");
  writeFits(folder + "/fits.step");
  writeCloseFits(folder + "/close-fits.step");
  writeRoundFits(folder + "/round-fits.step");
  writeTappedNut(folder + "/tapped-nut.step");
  writeBolt(folder + "/bolt-and-nut.step", 1.0, true);
  writeBolt(folder + "/bolt-in-plate.step", 1.0, false);
  writeBolt(folder + "/large-bolt-and-nut.step", 25.4, true);
  writeValidated(folder + "/validated.step", 1.0, 0.0);
  writeValidated(folder + "/validated-wrong.step", 1.05, 1.0);
  writeOddShapes(folder + "/odd-shapes.step");
  writeCosmeticThreads(folder + "/cosmetic-threads.step");
  writeSplit(folder);
  writeFrames(folder + "/frames.step");
  writePart(folder + "/ribbed.step", "ribbed",
            compoundOf({blockAt(0, 0, 0, 60, 20, 10), blockAt(0, 0, 10, 20, 20, 30), sheetAt(100)}));
  writeIges(folder + "/surfaces.igs", plateAndPin(), false);
  writeIges(folder + "/solids.iges", plateAndPin(), true, "INCH");
  writeIges(folder + "/sheet.igs", {sheetAt(0)}, false);
  writeBrep(folder + "/solids.brep", compoundOf(plateAndPin()));
  writeBrep(folder + "/shell.brep", TopExp_Explorer(box(30, 20, 10), TopAbs_SHELL).Current());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    writeAll(argv[1]);
  } catch (const std::string& why) {
    std::cerr << why << "\n";
    return 1;
  }
  return 0;
}
