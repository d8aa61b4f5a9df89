#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "foam_cases/dictionary.h"

namespace tw {

/// The program that captures the water's surface geometrically (openfoam.com alone).
inline constexpr const char* geometric_solver = "interIsoFoam";

/// Which OpenFOAM a case is written for. Two vendors share most keywords; every difference between them is one function
/// here, and nowhere else. openfoam.com v1912 is what the settings were measured with; the rest follows the vendors'
/// documentation, tutorials and sources (openfoam.com to v2412, openfoam.org 7 to 13); of it openfoam.org 12 and 13 were run.
struct Flavour {
    enum class Vendor {
        com,
        org
    } vendor = Vendor::com;  ///< openfoam.com (v1912, v2312...), openfoam.org (7, 10, 11...)
    int number = 1912;

    static Flavour from_version(std::string_view vendor, std::string_view version);  ///< "openfoam.org", "10"
    std::string vendor_name() const { return vendor == Vendor::com ? "openfoam.com" : "openfoam.org"; }
    std::string version_name() const {
        return vendor == Vendor::com ? "v" + std::to_string(number) : std::to_string(number);
    }

    /// The solver's program and arguments: interFoam; openfoam.org from 11: foamRun -solver incompressibleVoF.
    std::string solver_program() const;
    std::vector<std::string> solver_arguments() const;
    /// postProcess; openfoam.org from 11: foamPostProcess.
    std::string post_process_program() const;
    /// surfaceFeatureExtract; openfoam.org from 7: surfaceFeatures. The dictionary carries the same name + Dict.
    std::string surface_features_program() const;
    bool features_per_surface() const;  ///< one sub-dictionary per surface (surfaceFeatureExtract) or one list for all

    std::string turbulence_file() const;       ///< turbulenceProperties; openfoam.org from 8: momentumTransport
    std::string turbulence_model_key() const;  ///< RASModel; openfoam.org from 8: model
    bool phases_in_files() const;              ///< openfoam.org from 10: phaseProperties and physicalProperties.<phase>
    bool compression_in_scheme() const;        ///< openfoam.org from 8: div(phi,alpha) interfaceCompression, no cAlpha
    std::string stop_file_object()
        const;  ///< function object that watches for a file: abort; openfoam.org from 8: stopAtFile
    List library(std::string_view name) const;  ///< (forces); openfoam.org: ("libforces.so")
    bool field_extremes() const;                ///< fieldMinMax is there; openfoam.org from 9: volFieldValue alone
    std::string iso_surface() const;            ///< isoSurfaceCell; openfoam.org: isoSurface, which cuts cells too
    bool distance_in_box_level() const;         ///< openfoam.org has `level` of a box as one number alone
    bool keeps_planes_without_faces() const;    ///< openfoam.org: createPatch leaves symmetry planes that are empty
    /// openfoam.com, and openfoam.org from 11: bodies and tanks that move.
    bool moves_bodies_and_tanks() const;
    /// Velocity of a wall that moves, and of one along which water slips. Those that let water go have their own
    /// (foam_cases/ventilated_wall): openfoam.com.
    std::string moving_wall(bool lets_go) const;
    std::string slip_wall(bool lets_go) const;
    bool objects_set_steps() const;       ///< openfoam.com, or writeControl must be adjustableRunTime too
    bool steps_limited_by_table() const;  ///< openfoam.org from 12: fluidMaxDeltaT, the largest time step by a table
    bool end_of_object() const;    ///< openfoam.org: the last time of a function object is endTime, timeEnd elsewhere
    bool expressions() const;      ///< openfoam.com: a boundary value may be an expression of the place
    bool tables_in_files() const;  ///< openfoam.com: a prescribed motion is a file beside its dictionary, else in it
    /// What chooses cells, of a function object or a moving mesh: select; openfoam.org from 13: cellZone.
    std::string cell_selection() const;
    /// Of constant/: fvOptions; openfoam.org from 9: fvModels.
    std::string sources_file() const;
    /// openfoam.com, and openfoam.org from 12: what foam_cases/forcing_zones is written for.
    bool has_forcing_zones() const;
    /// openfoam.org from 13: translation and rotation, or acceleration, angular velocity and angular acceleration, are
    /// tables of their own.
    bool motion_in_parts() const;
    /// constant/dynamicMeshDict of one motion solver, with the `library` that has it (empty: the one of solid-body motion)
    /// and its coefficients. openfoam.org has a mover around it, up to 11 in a library of its own.
    Dictionary motion_solver(std::string_view name, std::string_view library, const Dictionary& coefficients) const;
    /// openfoam.org: a function of time by rows of time and value, read as the same spline as openfoam.com's tables.
    Dictionary table_of_times(const List& rows) const;
};

}  // namespace tw
