#include "suite/suite.h"

namespace tw {

const char* const suite_help =
    "A suite is a folder with suite.toml, and for more cases cases/NAME.toml with the keys of one [[case]]:\n\n"
    "  title = \"My suite\"\n"
    "  [[case]]\n"
    "  name   = \"barge\"\n"
    "  family = \"tanks\"                  # any word; the report sums up by it\n"
    "  tier   = \"minutes\"                # minutes, hour, night, gpu: --tier runs it and those before it\n"
    "  why    = \"The heave of a barge decides its freeboard.\"\n"
    "  scene  = \"barge.toml\"             # relative to this file; or several [[case.scene]] name, file\n"
    "  changes = { scale = 2, duration = \"3 s\" }   # also speed, trim, spacing, near_hull, hull, effects_on, "
    "effects_off\n"
    "  uncertain = { hull.trim = \"0.1 deg\" }  # of any number of the scene: enters U_val by two more coarse runs\n"
    "  [[case.quantity]]\n"
    "  name   = \"lift\"                   # as in report.json\n"
    "  unit   = \"N\"\n"
    "  truth  = \"627.8 N\"                # or formula with parameters; csv, column, row; record: a mapping of "
    "import\n"
    "  uncertainty = \"1 %\"               # of the truth, half width of its 95 % interval\n"
    "  source = \"weighed\"\n"
    "  goal   = \"2 %\"\n"
    "  # reading = { table = \"height\", column = \"gauge\", kind = \"period\", from = \"1 s\" }\n"
    "  #           in place of a quantity of the report; kinds: mean, at, largest, smallest, crossing, period\n"
    "  # known_miss = { sph = \"why\" }    # falls short, and that is known\n\n"
    "docs/validating.md says more; --formulas lists the formulas.\n";

}  // namespace tw
