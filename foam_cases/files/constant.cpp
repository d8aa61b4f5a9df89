#include <cmath>

#include "foam_cases/files/case_files.h"

namespace tw {

std::string gravity_file(const CasePlan& plan) {
    return foam_file("uniformDimensionedVectorField", "g",
                     {{"dimensions", acceleration}, {"value", Vec3(0, 0, -std::abs(plan.scene->water.gravity))}});
}

/// constant/turbulenceProperties: laminar for the counterpart of an SPH run without physical viscosity, else k-omega
/// SST.
std::string turbulence_file(const CasePlan& plan) {
    Dictionary d{{"simulationType", Word(plan.turbulent ? "RAS" : "laminar")}};
    if (plan.turbulent)
        d.add("RAS", Dictionary{{plan.flavour.turbulence_model_key(), Word("kOmegaSST")},
                                {"turbulence", true},
                                {"printCoeffs", false}});
    return foam_file("dictionary", plan.flavour.turbulence_file(), d);
}

/// constant/transportProperties; or, openfoam.org from 10, phaseProperties and physicalProperties.water and .air.
std::vector<CaseFile> phase_files(const CasePlan& plan) {
    const Water& w = plan.scene->water;
    const double tension = plan.scene->effect_on("surface_tension") ? w.surface_tension : 0;
    const auto fluid = [&](double nu, double rho) {
        return Dictionary{{plan.flavour.phases_in_files() ? "viscosityModel" : "transportModel",
                           Word(plan.flavour.phases_in_files() ? "constant" : "Newtonian")},
                          {"nu", nu},
                          {"rho", rho}};
    };
    const Dictionary water = fluid(w.kinematic_viscosity, w.density),
                     air = fluid(w.air_kinematic_viscosity, w.air_density);
    const List phases{Word("water"), Word("air")};
    if (plan.flavour.phases_in_files())
        return {{"constant/phaseProperties",
                 foam_file("dictionary", "phaseProperties", {{"phases", phases}, {"sigma", tension}})},
                {"constant/physicalProperties.water", foam_file("dictionary", "physicalProperties.water", water)},
                {"constant/physicalProperties.air", foam_file("dictionary", "physicalProperties.air", air)}};
    return {{"constant/transportProperties",
             foam_file("dictionary", "transportProperties",
                       {{"phases", phases}, {"water", water}, {"air", air}, {"sigma", tension}})}};
}

}  // namespace tw
