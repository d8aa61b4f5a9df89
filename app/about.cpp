#include "app/about.h"

namespace tw::app {

const char* const about_uncertainty =
    "The first column is the spacing (cell or particle size), every further column one quantity:\n\n"
    "  h [m], drag [N], lift [N]\n"
    "  0.05,  412.1,    2722\n"
    "  0.07,  418.0,    2711\n"
    "  0.10,  431.0,    2690\n"
    "  0.14,  449.5,    2655\n\n"
    "In its place may stand a count, N (\"cells\", \"particles\", \"nodes\"), whose spacing is N^(-1/d) with d from\n"
    "--dimensions or the header (\"cells (3d)\"), or a number per length (\"cells per beam\").\n"
    "Commas, semicolons or tabs; lines that begin with # and empty lines are skipped; rows in any order.\n"
    "From three sizes on U comes from a fit of trend and noise. Beside it stand the least squares of Eca & Hoekstra\n"
    "(2014; four sizes), and of the three finest sizes the grid convergence index of Celik et al. (2008) and the\n"
    "factor of safety of Xing & Stern (2010). Two sizes: the order is assumed (--order), the factor is 3. One: no U.\n"
    "U is meant as half the width of a 95 % interval about the finest value. That a table does not converge is\n"
    "a result, not an error: the exit status is 0.\n\n";

const char* const about_import =
    "The mapping names the source, the scene it belongs to, and its columns:\n\n"
    "  kind = \"csv\"                   # or dualsphysics (ComputeForces CSV), openfoam (a case folder)\n"
    "  name = \"towing tank\"\n"
    "  source = \"forces.csv\"          # relative to the mapping file\n"
    "  scene = \"planing_prism.toml\"   # or the record.h5 of a run of it\n"
    "  half_model = false             # true: loads of half a hull, to be doubled\n"
    "  time = { column = \"t\", unit = \"ms\" }\n"
    "  [forces]                       # fx fy fz my; further [height] [pressure] [samples]\n"
    "  fx = { column = \"Drag\", unit = \"kN\" }\n"
    "  fz = { column = 3, unit = \"N\", scale = -1 }\n\n"
    "x runs with the stream to the stern, z up; forces are those of the water on the hull, my is bow up.\n\n";

const char* const about_ablate =
    "Runs the scene as it is, then once for each effect with that one effect switched: what is on goes off, what is\n"
    "off goes on. The table shows, for each, the change of every measured quantity in per cent with its 95 % "
    "interval,\n"
    "beside what the effect plan had estimated, and the change of the processor time.\n\n"
    "  twinwake ablate my.toml                                      every effect that can be switched\n"
    "  twinwake ablate my.toml --effects surface_tension shifting --method sph\n"
    "  twinwake ablate my.toml --effect viscosity=on --effects no_slip turbulence\n\n"
    "For effects of the particle method alone no mesh run is made. An effect that needs another one which is off is\n"
    "switched in the run that has the other one on, and compared with that run.\n\n"
    "A finished run is reused; after a stop (Ctrl-C) the same command continues. A run that fails is listed with its\n"
    "reason and does not stop the others.\n\n";

const char* const about_openfoam =
    "\nWhich OpenFOAM is taken:\n"
    "  module, own build  the one whose environment is loaded in this shell (module load, or source its etc/bashrc)\n"
    "  container          export TWINWAKE_OPENFOAM_PREFIX=\"apptainer exec of.sif openfoam2506\": words after which a\n"
    "                     program runs in OpenFOAM's environment; the run's folder has the same path there (--bind)\n"
    "  neither            Debian's package with the interFoam of twinwake setup-openfoam, then the usual "
    "places\n"
    "Separation at walls (ventilation), forcing zones and a hull that is held until its release need libraries;\n"
    "twinwake setup-openfoam builds them for the release that is loaded.\n";

const char* const about_setup_openfoam =
    "The interFoam of Debian's and Ubuntu's package is miscompiled: velocities are wrong on meshes that are not\n"
    "axis-aligned. This builds it from the source of the same package, linked to the package's libraries, with the\n"
    "fault switched off: two minutes on two cores, 0.4 GB of disk meanwhile. As root or as a user:\n\n"
    "  sudo apt-get install --no-install-recommends openfoam dpkg-dev g++ make flex libopenmpi-dev zlib1g-dev bzip2\n"
    "  twinwake setup-openfoam                    into ~/.local/share/twinwake/openfoam (.openfoam in a checkout)\n"
    "  sudo twinwake setup-openfoam --for-all-users\n\n"
    "Where the environment of another release is loaded, only the libraries for it are built, into the same folder.\n"
    "What is there and belongs to the installed package is kept. At the end the solver is tested on a flow with an "
    "exact\n"
    "solution, as doctor does.\n\n";

}  // namespace tw::app
