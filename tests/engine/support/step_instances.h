#pragma once

#include <string>

#include "tests/engine/support/step_files.h"

namespace glissade::test {

/// The second of two instances of a part, as the file states it. Points are in millimetres.
struct SecondPart {
  std::string x = "1.,0.,0.";
  std::string y = "0.,1.,0.";
  std::string z = "0.,0.,1.";
  std::string scale = "1.";
  std::string mapped = "10.,20.,5.";  ///< point of the part that is put at (7, -3, 100)
  std::string mappedX = "1.,0.,0.";
  std::string mappedZ = "0.,0.,1.";
};

/// The part of a test file as it is, and the second one.
inline std::string partTwice(const SecondPart& second, const std::string& file) {
  std::string text = stepText(file);
  const std::size_t solid = text.find("ADVANCED_BREP_SHAPE_REPRESENTATION");
  const std::string shape =
      text.substr(text.rfind('#', solid), text.find_first_of(" =", text.rfind('#', solid)) - text.rfind('#', solid));
  const std::size_t list = text.find("(#", solid);
  const std::string origin = text.substr(list + 1, text.find(',', list) - list - 1);
  const std::size_t contextAt = text.find("),#", list) + 2;
  const std::string context = text.substr(contextAt, text.find(')', contextAt) - contextAt);
  const std::string added =
      "#900001=REPRESENTATION_MAP(" + origin + "," + shape + ");\n#900002=CARTESIAN_POINT('',(0.,0.,0.));\n" +
      "#900003=DIRECTION('',(" + second.x + "));\n#900004=DIRECTION('',(" + second.y + "));\n#900005=DIRECTION('',(" +
      second.z + "));\n#900006=CARTESIAN_POINT('',(7.,-3.,100.));\n" +
      "#900007=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#900003,#900004,#900006," + second.scale +
      ",#900005);\n#900008=MAPPED_ITEM('',#900019,#900007);\n#900009=DIRECTION('',(1.,0.,0.));\n" +
      "#900013=DIRECTION('',(0.,1.,0.));\n#900014=DIRECTION('',(0.,0.,1.));\n" +
      "#900010=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#900009,#900013,#900002,1.,#900014);\n" +
      "#900011=MAPPED_ITEM('',#900001,#900010);\n#900012=SHAPE_REPRESENTATION('',(" + origin + ",#900011,#900008)," +
      context + ");\n#900015=CARTESIAN_POINT('',(" + second.mapped + "));\n#900016=DIRECTION('',(" + second.mappedZ +
      "));\n#900017=DIRECTION('',(" + second.mappedX +
      "));\n#900018=AXIS2_PLACEMENT_3D('',#900015,#900016,#900017);\n" + "#900019=REPRESENTATION_MAP(#900018," + shape +
      ");\nENDSEC;\nEND-ISO";
  const std::size_t definition = text.find("SHAPE_DEFINITION_REPRESENTATION(");
  const std::size_t used = text.find("," + shape + ")", definition);
  text.replace(used, shape.size() + 2, ",#900012)");
  return replaced(text, "ENDSEC;\nEND-ISO", added);
}

}  // namespace glissade::test
