#pragma once

#include <regex>
#include <string>

#include "tests/engine/support/step_files.h"

namespace glissade::test {

/// unit.step whose second pin is a product of its own, "stud": its shape is the pin's as a mapped item.
inline std::string mappedStepText() {
  std::string text = stepText("unit.step");
  const auto group = [&text](const std::string& pattern) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(pattern)) ? found.str(1) : std::string("0");
  };
  const std::string formation =
      group(R"(#(\d+) = PRODUCT_DEFINITION_FORMATION\('','',#)" + group(R"(#(\d+) = PRODUCT\('pin')") + R"(\))");
  const std::string definition = R"(PRODUCT_DEFINITION\('design','',#)" + formation;
  const std::string shape =
      group(R"(#(\d+) = PRODUCT_DEFINITION_SHAPE\('','',#)" + group(R"(#(\d+) = )" + definition) + R"(\))");
  const std::string solid = group(R"(SHAPE_DEFINITION_REPRESENTATION\(#)" + shape + R"(,#(\d+)\))");
  const std::string items = "#" + solid + R"( = ADVANCED_BREP_SHAPE_REPRESENTATION\('',\(#)";
  const std::string origin = group(items + R"((\d+))");
  const std::string units = group(items + R"(\d+,#\d+\),#(\d+))");
  const std::string use = group(R"(#(\d+) = NEXT_ASSEMBLY_USAGE_OCCURRENCE\('3')");
  const std::string placement =
      group(R"(CONTEXT_DEPENDENT_SHAPE_REPRESENTATION\(#(\d+),#)" +
            group(R"(#(\d+) = PRODUCT_DEFINITION_SHAPE\('Placement','[^']*',#)" + use + R"(\s*\))"));
  const std::string added =
      "#90001 = PRODUCT('stud','stud','',(#" + group(R"(PRODUCT\('pin','pin','',\(#(\d+))") + "));\n" +
      "#90002 = PRODUCT_DEFINITION_FORMATION('','',#90001);\n#90003 = PRODUCT_DEFINITION('design','',#90002,#" +
      group(definition + R"(,#(\d+))") + ");\n#90004 = PRODUCT_DEFINITION_SHAPE('','',#90003);\n" +
      "#90005 = REPRESENTATION_MAP(#" + origin + ",#" + solid + ");\n#90006 = MAPPED_ITEM('',#90005,#" + origin +
      ");\n#90007 = SHAPE_REPRESENTATION('',(#" + origin + ",#90006),#" + units +
      ");\n#90008 = SHAPE_DEFINITION_REPRESENTATION(#90004,#90007);\nENDSEC;\nEND-ISO";
  text = std::regex_replace(text, std::regex("(#" + use + R"( = [A-Z_]+\('3','[^']*','',#\d+,)#\d+)"), "$1#90003");
  text = std::regex_replace(text, std::regex("(#" + placement + R"( = \( REPRESENTATION_RELATIONSHIP\('','',)#\d+)"),
                            "$1#90007");
  return replaced(text, "ENDSEC;\nEND-ISO", added);
}

}  // namespace glissade::test
