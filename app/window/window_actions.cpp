#include "app/window/window_actions.h"

#include <iterator>

#include "app/window/shell_actions.h"
#include "widgets/arrange/arrange_actions.h"
#include "widgets/contacts/contacts_actions.h"
#include "widgets/devices/devices_actions.h"
#include "widgets/files/files_actions.h"
#include "widgets/headset/headset_actions.h"
#include "widgets/help/help_actions.h"
#include "widgets/measure/measure_actions.h"
#include "widgets/paths/paths_actions.h"
#include "widgets/places/places_actions.h"
#include "widgets/product/product_actions.h"
#include "widgets/run/run_actions.h"
#include "widgets/section/section_actions.h"
#include "widgets/sequence/sequence_actions.h"
#include "widgets/studies/studies_actions.h"
#include "widgets/view/view_actions.h"

namespace glissade {

std::vector<ActionSpec> windowActions() {
  std::vector<ActionSpec> all;
  for (std::vector<ActionSpec> actions :
       {filesActions(), productActions(), arrangeActions(), contactsActions(), placesActions(), runActions(),
        devicesActions(), pathsActions(), sequenceActions(), studiesActions(), viewActions(), sectionActions(),
        measureActions(), headsetActions(), helpActions(), shellActions()}) {
    std::move(actions.begin(), actions.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace glissade
