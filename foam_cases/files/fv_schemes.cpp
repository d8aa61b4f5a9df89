#include "foam_cases/files/case_files.h"

namespace tw {

/// system/fvSchemes: second-order upwind for momentum, van Leer with interface compression for the water fraction. Round
/// a body that enters the water first-order upwind: with the second order the water of an entry does not leave the body reliably
/// (docs/decisions/032-rigid-bodies.md).
std::string fv_schemes(const CasePlan& plan) {
    Dictionary divergence{
        {"default", Word("none")},
        {"div(rhoPhi,U)", Word(!plan.mesh_moves() || plan.stream ? "Gauss linearUpwind limitedGrad" : "Gauss upwind")}};
    if (plan.mesh_moves()) divergence.add("div(U)", Word("Gauss linear"));
    if (plan.flavour.compression_in_scheme()) {
        divergence.add("div(phi,alpha)", Value::sequence({Word("Gauss interfaceCompression vanLeer"),
                                                          plan.scene->fvm.interface_compression}));
    } else {
        divergence.add("div(phi,alpha)", Word("Gauss vanLeer"));
        divergence.add("div(phirb,alpha)", Word("Gauss linear"));
    }
    if (plan.turbulent)
        divergence.add({{"div(phi,k)", Word("Gauss upwind")}, {"div(phi,omega)", Word("Gauss upwind")}});
    divergence.add("div(((rho*nuEff)*dev2(T(grad(U)))))", Word("Gauss linear"));
    return foam_file("dictionary", "fvSchemes",
                     {{"ddtSchemes", Dictionary{{"default", Word("Euler")}}},
                      {"gradSchemes", Dictionary{{"default", Word("Gauss linear")},
                                                 {"limitedGrad", Word("cellLimited Gauss linear 1")}}},
                      {"divSchemes", divergence},
                      {"laplacianSchemes", Dictionary{{"default", Word("Gauss linear limited corrected 0.5")}}},
                      {"interpolationSchemes", Dictionary{{"default", Word("linear")}}},
                      {"snGradSchemes", Dictionary{{"default", Word("limited corrected 0.5")}}},
                      {"wallDist", Dictionary{{"method", Word("meshWave")}}}});
}

}  // namespace tw
