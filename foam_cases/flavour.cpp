#include "foam_cases/flavour.h"

#include <charconv>

namespace tw {

Flavour Flavour::from_version(std::string_view vendor_text, std::string_view version) {
    Flavour f;
    f.vendor = vendor_text == "openfoam.org" ? Vendor::org : Vendor::com;
    while (!version.empty() && (version[0] < '0' || version[0] > '9')) version.remove_prefix(1);
    if (std::from_chars(version.data(), version.data() + version.size(), f.number).ec != std::errc{}) f.number = 0;
    return f;
}

namespace {
bool org_from(const Flavour& f, int number) { return f.vendor == Flavour::Vendor::org && f.number >= number; }
}  // namespace

std::string Flavour::solver_program() const { return org_from(*this, 11) ? "foamRun" : "interFoam"; }
std::vector<std::string> Flavour::solver_arguments() const {
    return org_from(*this, 11) ? std::vector<std::string>{"-solver", "incompressibleVoF"} : std::vector<std::string>{};
}
std::string Flavour::post_process_program() const { return org_from(*this, 11) ? "foamPostProcess" : "postProcess"; }
std::string Flavour::surface_features_program() const {
    return org_from(*this, 7) ? "surfaceFeatures" : "surfaceFeatureExtract";
}
bool Flavour::features_per_surface() const { return !org_from(*this, 7); }
std::string Flavour::turbulence_file() const {
    return org_from(*this, 8) ? "momentumTransport" : "turbulenceProperties";
}
std::string Flavour::turbulence_model_key() const { return org_from(*this, 8) ? "model" : "RASModel"; }
bool Flavour::phases_in_files() const { return org_from(*this, 10); }
bool Flavour::compression_in_scheme() const { return org_from(*this, 8); }
std::string Flavour::stop_file_object() const { return org_from(*this, 8) ? "stopAtFile" : "abort"; }
List Flavour::library(std::string_view name) const {
    if (vendor == Vendor::org) return {Quoted("lib" + std::string(name) + ".so")};
    return {Word(name)};
}
bool Flavour::field_extremes() const { return !org_from(*this, 9); }
std::string Flavour::iso_surface() const { return vendor == Vendor::org ? "isoSurface" : "isoSurfaceCell"; }
bool Flavour::distance_in_box_level() const { return vendor == Vendor::com; }
bool Flavour::keeps_planes_without_faces() const { return vendor == Vendor::org; }
std::string Flavour::moving_wall(bool lets_go) const {
    return lets_go && vendor == Vendor::com ? "ventilatedWallVelocity" : "movingWallVelocity";
}
std::string Flavour::slip_wall(bool lets_go) const {
    return lets_go && vendor == Vendor::com ? "ventilatedSlip" : "slip";
}
bool Flavour::moves_bodies_and_tanks() const { return vendor == Vendor::com || number >= 11; }
bool Flavour::objects_set_steps() const { return vendor == Vendor::com; }
bool Flavour::steps_limited_by_table() const { return org_from(*this, 12); }
bool Flavour::end_of_object() const { return vendor == Vendor::org; }
bool Flavour::tables_in_files() const { return vendor == Vendor::com; }
bool Flavour::expressions() const { return vendor == Vendor::com; }
std::string Flavour::cell_selection() const { return org_from(*this, 13) ? "cellZone" : "select"; }
std::string Flavour::sources_file() const { return org_from(*this, 9) ? "fvModels" : "fvOptions"; }
bool Flavour::has_forcing_zones() const { return vendor == Vendor::com || number >= 12; }
bool Flavour::motion_in_parts() const { return org_from(*this, 13); }

Dictionary Flavour::motion_solver(std::string_view name, std::string_view library_name,
                                  const Dictionary& coefficients) const {
    Dictionary d;
    if (vendor == Vendor::com) {
        d.add("dynamicFvMesh", Word("dynamicMotionSolverFvMesh"));
        if (!library_name.empty()) d.add("motionSolverLibs", library(library_name));
        return d.add("motionSolver", Word(name)).add(std::string(name) + "Coeffs", coefficients);
    }
    List libraries = library(library_name.empty() ? "fvMotionSolvers" : library_name);
    if (!org_from(*this, 12)) libraries.insert(libraries.begin(), Quoted("libfvMeshMovers.so"));
    d.add({{"type", Word("motionSolver")}, {"libs", libraries}, {"motionSolver", Word(name)}});
    return {{"mover", d.add(coefficients)}};
}

Dictionary Flavour::table_of_times(const List& rows) const {
    return {{"type", Word("table")}, {"interpolationScheme", Word("spline")}, {"values", rows}};
}

}  // namespace tw
