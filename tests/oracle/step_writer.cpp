#include "tests/oracle/step_writer.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <stdexcept>

namespace glissade::oracle {
namespace {

TopoDS_Face planeFace(const std::vector<Point>& corners) {
  BRepBuilderAPI_MakePolygon border;
  for (const Point& p : corners) border.Add(gp_Pnt(p[0], p[1], p[2]));
  border.Close();
  return BRepBuilderAPI_MakeFace(border.Wire(), true);
}

TopoDS_Shape faceted(const std::vector<Ring>& rings) {
  BRepBuilderAPI_Sewing sewing(1e-7);
  for (const Polygon& polygon : ringSolid(rings)) sewing.Add(planeFace(polygon.corners));
  sewing.Perform();
  TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
  if (!shells.More()) throw std::runtime_error("the faces make no shell");
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shells.Current()));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape revolved(const std::vector<Ring>& rings) {
  std::vector<Point> profile{{0.0, 0.0, rings.front().z}};
  for (const Ring& ring : rings) profile.push_back({std::hypot(ring.outline[0][0], ring.outline[0][1]), 0.0, ring.z});
  profile.push_back({0.0, 0.0, rings.back().z});
  TopoDS_Shape solid = BRepPrimAPI_MakeRevol(planeFace(profile), gp_Ax1(gp_Pnt(), gp_Dir(0, 0, 1))).Shape();
  TopExp_Explorer solids(solid, TopAbs_SOLID);
  if (!solids.More()) throw std::runtime_error("the profile makes no solid");
  TopoDS_Solid one = TopoDS::Solid(solids.Current());
  BRepLib::OrientClosedSolid(one);
  return one;
}

TopoDS_Shape solidOf(const std::vector<Ring>& rings, bool round) { return round ? revolved(rings) : faceted(rings); }

}  // namespace

void writeStep(const std::string& file, const std::vector<Ring>& rings, bool round) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // statistics on the standard output
  STEPControl_Writer writer;
  const bool written = writer.Transfer(solidOf(rings, round), STEPControl_AsIs) == IFSelect_RetDone &&
                       writer.Write(file.c_str()) == IFSelect_RetDone;
  if (!written) throw std::runtime_error(file + ": cannot be written");
}

double commonVolume(const TrappedPair& pair, double lifted) {
  gp_Trsf up;
  up.SetTranslation(gp_Vec(0.0, 0.0, lifted));
  const TopoDS_Shape object = solidOf(pair.object, pair.round).Moved(TopLoc_Location(up));
  BRepAlgoAPI_Common common(object, solidOf(pair.block, pair.round));
  if (!common.IsDone()) throw std::runtime_error("the common volume was not found");
  GProp_GProps properties;
  BRepGProp::VolumeProperties(common.Shape(), properties);
  return properties.Mass();
}

}  // namespace glissade::oracle
