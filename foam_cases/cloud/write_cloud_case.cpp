#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/cloud/cloud_case.h"
#include "foam_cases/dictionary.h"

namespace tw {
namespace {

constexpr int cells_along = 24;  ///< of the longest side of the room, where the air is not the same everywhere

struct Grid {
    std::array<int, 3> cells{1, 1, 1};
    Vec3 edge;
};

/// Cells of the room: one where the air is the same everywhere, else nearly cubes.
Grid grid_of(const CloudCase& cloud) {
    Grid g;
    const Vec3 size = cloud.room.size();
    for (int a = 0; a < 3; ++a) {
        const int n = static_cast<int>(std::ceil(cells_along * size[a] / size.maxCoeff()));
        if (cloud.air_velocity) g.cells[static_cast<std::size_t>(a)] = std::max(n, 2);
        g.edge[a] = size[a] / g.cells[static_cast<std::size_t>(a)];
    }
    return g;
}

std::string block_mesh(const CloudCase& cloud, const Grid& grid) {
    const Vec3 &a = cloud.room.min, &b = cloud.room.max;
    List vertices;
    for (const double z : {a.z(), b.z()})
        for (const auto& [x, y] : {std::pair{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}})
            vertices.push_back(Vec3(x, y, z));
    const auto [nx, ny, nz] = grid.cells;
    const List blocks{
        Value::sequence({Word("hex (0 1 2 3 4 5 6 7)"), List{nx, ny, nz}, Word("simpleGrading (1 1 1)")})};
    List faces;
    for (const char* face : {"(0 1 5 4)", "(3 7 6 2)", "(0 3 2 1)", "(4 5 6 7)", "(0 4 7 3)", "(1 2 6 5)"})
        faces.push_back(Word(face));
    return foam_file(
        "dictionary", "blockMeshDict",
        {{"scale", 1},
         {"convertToMeters", 1},
         {"vertices", vertices},
         {"blocks", blocks},
         {"edges", List{}},
         {"boundary", List{Value::named(Word("sides"), Dictionary{{"type", Word("patch")}, {"faces", faces}})}}});
}

std::string control(const CloudCase& cloud) {
    return foam_file("dictionary", "controlDict",
                     {{"application", Word(cloud_solver)},
                      {"startFrom", Word("startTime")},
                      {"startTime", 0},
                      {"stopAt", Word("endTime")},
                      {"endTime", cloud.duration},
                      {"deltaT", cloud.time_step},
                      {"writeControl", Word("runTime")},
                      {"writeInterval", cloud.duration / cloud.frames},
                      {"writeFormat", Word("ascii")},
                      {"writePrecision", 12},
                      {"writeCompression", Word("off")},
                      {"timeFormat", Word("general")},
                      {"timePrecision", 9},
                      {"runTimeModifiable", false}});
}

/// The solver solves no field: only its interpolation of the air's velocity needs schemes.
std::string schemes() {
    const auto only = [](const char* scheme) { return Dictionary{{"default", Word(scheme)}}; };
    return foam_file("dictionary", "fvSchemes",
                     {{"ddtSchemes", only("none")},
                      {"gradSchemes", only("Gauss linear")},
                      {"divSchemes", only("none")},
                      {"laplacianSchemes", only("none")},
                      {"interpolationSchemes", only("linear")},
                      {"snGradSchemes", only("none")}});
}

/// 0/U: the air's velocity at the centres of the cells, which blockMesh numbers along x first, z last.
std::string air_field(const CloudCase& cloud, const Grid& grid) {
    std::vector<Vec3> u;
    if (!cloud.air_velocity) u.push_back(cloud.wind);
    for (int k = 0; cloud.air_velocity && k < grid.cells[2]; ++k)
        for (int j = 0; j < grid.cells[1]; ++j)
            for (int i = 0; i < grid.cells[0]; ++i)
                u.push_back(
                    cloud.air_velocity(cloud.room.min + Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(grid.edge)));
    return foam_file(
        "volVectorField", "U",
        {{"dimensions", velocity},
         {"internalField", u.size() == 1 ? Value::sequence({Word("uniform"), u.front()}) : Value::nonuniform(u)},
         {"boundaryField", Dictionary{{"sides", Dictionary{{"type", Word("zeroGradient")}}}}}});
}

/// Every row of constant/droplets is let go once, in the first step: OpenFOAM injects the whole part of
/// rows * time step * parcelsPerSecond.
Dictionary injection(const CloudCase& cloud) {
    const auto rows = static_cast<double>(cloud.parcels.size());
    return {{"type", Word("kinematicLookupTableInjection")},
            {"massTotal", 1},  // means nothing where every parcel is one sphere
            {"parcelBasisType", Word("fixed")},
            {"nParticle", 1},
            {"SOI", 0},
            {"inputFile", Quoted("droplets")},
            {"duration", 0.5 * cloud.time_step},
            {"parcelsPerSecond", (1 + 0.5 / rows) / cloud.time_step},
            {"randomise", false}};
}

std::string cloud_properties(const CloudCase& cloud) {
    const Dictionary solution{
        {"active", true},
        {"coupled", false},
        {"transient", true},
        {"cellValueSourceCorrection", false},
        {"maxCo", 1},
        {"interpolationSchemes", Dictionary{{"rho", Word("cell")}, {"U", Word("cellPoint")}, {"mu", Word("cell")}}},
        {"integrationSchemes", Dictionary{{"U", Word("analytical")}}}};
    const Dictionary escape{{"type", Word("escape")}};
    Dictionary models{{"particleForces", Dictionary{{"sphereDrag", Dictionary{}}, {"gravity", Dictionary{}}}},
                      {"injectionModels", Dictionary{{"droplets", injection(cloud)}}},
                      {"dispersionModel", Word("none")},
                      {"patchInteractionModel", Word("localInteraction")},
                      {"localInteractionCoeffs", Dictionary{{"patches", List{Value::named(Word("sides"), escape)}}}}};
    for (const char* other : {"heatTransferModel", "surfaceFilmModel", "collisionModel", "stochasticCollisionModel"})
        models.add(other, Word("none"));
    return foam_file("dictionary", "kinematicCloudProperties",
                     {{"solution", solution},
                      {"constantProperties", Dictionary{{"rho0", cloud.liquid_density},
                                                        {"youngsModulus", 1e6},
                                                        {"poissonsRatio", 0.3},
                                                        {"constantVolume", false}}},
                      {"subModels", models},
                      {"cloudFunctions", Dictionary{}}});
}

/// constant/droplets: place, velocity, diameter, density and rate, which nobody reads, of each.
std::string droplet_table(const CloudCase& cloud) {
    List rows;
    for (const Parcel& p : cloud.parcels)
        rows.push_back(Value::sequence({p.place, p.velocity, p.diameter, cloud.liquid_density, 1}));
    return foam_list_file("dictionary", "droplets", rows);
}

void check(const CloudCase& cloud) {
    if (cloud.parcels.empty()) throw InputError("OpenFOAM cloud: no droplets to write");
    if (!(cloud.duration > 0) || !(cloud.time_step > 0) || cloud.frames < 1 || !(cloud.air_density > 0) ||
        !(cloud.air_kinematic_viscosity > 0) || !(cloud.liquid_density > cloud.air_density))
        throw InputError(
            "OpenFOAM cloud: duration, time step, frames, densities and viscosity are above 0, and the "
            "liquid is denser than the air");
    for (std::size_t i = 0; i < cloud.parcels.size(); ++i) {
        const Parcel& p = cloud.parcels[i];
        if (!(p.diameter > 0))
            throw InputError(fmt::format("OpenFOAM cloud: droplet {} has a diameter of {:g} m; expected above 0", i + 1,
                                         p.diameter));
        if (!(p.place.array() > cloud.room.min.array()).all() || !(p.place.array() < cloud.room.max.array()).all())
            throw InputError(fmt::format("OpenFOAM cloud: droplet {} starts at ({:g}, {:g}, {:g}) m, outside the room",
                                         i + 1, p.place.x(), p.place.y(), p.place.z()));
    }
}

}  // namespace

void write_cloud_case(const CloudCase& cloud, const std::filesystem::path& folder) {
    check(cloud);
    const Grid grid = grid_of(cloud);
    const Vec3 gravity =
        cloud.buoyancy ? cloud.gravity : cloud.gravity / (1 - cloud.air_density / cloud.liquid_density);
    const auto with_dimensions = [](const char* name, const Dimensions& dimensions, double value) {
        return Value::sequence({Word(name), dimensions, value});
    };
    const std::pair<const char*, std::string> files[] = {
        {"system/blockMeshDict", block_mesh(cloud, grid)},
        {"system/controlDict", control(cloud)},
        {"system/fvSchemes", schemes()},
        {"system/fvSolution", foam_file("dictionary", "fvSolution", {{"solvers", Dictionary{}}})},
        {"constant/transportProperties",
         foam_file("dictionary", "transportProperties",
                   {{"rhoInf", with_dimensions("rhoInf", density_units, cloud.air_density)},
                    {"transportModel", Word("Newtonian")},
                    {"nu", with_dimensions("nu", diffusivity, cloud.air_kinematic_viscosity)}})},
        {"constant/turbulenceProperties",
         foam_file("dictionary", "turbulenceProperties", {{"simulationType", Word("laminar")}})},
        {"constant/g",
         foam_file("uniformDimensionedVectorField", "g", {{"dimensions", acceleration}, {"value", gravity}})},
        {"constant/kinematicCloudProperties", cloud_properties(cloud)},
        {"constant/droplets", droplet_table(cloud)},
        {"0/U", air_field(cloud, grid)},
    };
    for (const auto& [name, text] : files) {
        std::filesystem::create_directories((folder / name).parent_path());
        write_text_atomically(folder / name, text);
    }
}

}  // namespace tw
