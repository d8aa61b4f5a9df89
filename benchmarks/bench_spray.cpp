#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>

#include "base/atomic_file.h"
#include "spray/air/foam_air.h"
#include "spray/flight/fly.h"

// Throughput of the droplets' flight: bench_spray [droplets] prints a table. Droplets of 0.2 to 5 mm leave a place in
// all directions upward at 5 to 40 m/s and fly for one second; once in uniform air, once in a table over z, once
// towards a disc of 4800 triangles; and once in the field of an OpenFOAM case, a block of coarse and of finer cubes.

namespace {

using namespace tw;
using namespace tw::spray;

std::vector<Droplet> fountain(std::size_t count) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Droplet> droplets(count);
    for (Droplet& d : droplets) {
        const double around = 2 * std::numbers::pi * unit(random), up = unit(random), speed = 5 + 35 * unit(random);
        const double level = std::sqrt(1 - up * up);
        d.velocity = speed * Vec3(level * std::cos(around), level * std::sin(around), up);
        d.diameter = 2e-4 * std::pow(25, unit(random));
    }
    return droplets;
}

Surface disc(const Vec3& centre, double radius) {
    constexpr int rings = 20, sectors = 120;
    Surface s;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double a = 2 * std::numbers::pi * j / sectors, r = radius * i / rings;
            s.points.push_back(centre + r * Vec3(0, std::cos(a), std::sin(a)));
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const int a = i * sectors + j, b = i * sectors + (j + 1) % sectors;
            s.triangles.push_back({a, a + sectors, b + sectors});
            s.triangles.push_back({a, b + sectors, b});
        }
    return s;
}

/// A block of cubes of `size` as an OpenFOAM case of text, with a wind that grows with the height and turns.
void write_block(const std::filesystem::path& folder, const Box& box, double size) {
    const Vec3 cells = (box.size() / size).array().round();
    const auto nx = static_cast<int>(cells.x()), ny = static_cast<int>(cells.y()), nz = static_cast<int>(cells.z());
    const auto put = [&](const char* file, const char* kind, const std::string& body) {
        const std::filesystem::path path = folder / file;
        std::filesystem::create_directories(path.parent_path());
        write_text_atomically(path, fmt::format("FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n{}",
                                                kind, path.filename().string(), body));
    };
    const auto list = [](std::size_t count, const std::string& items) {
        return fmt::format("{}\n(\n{})\n", count, items);
    };
    put("system/controlDict", "dictionary", "startTime 0; deltaT 1; writeInterval 1;\n");
    const auto point = [&](int i, int j, int k) { return i + (nx + 1) * (j + (ny + 1) * k); };
    const auto cell = [&](int i, int j, int k) { return i + nx * (j + ny * k); };
    std::string points, inner, outer, owner, outer_owner, neighbour, u;
    std::size_t n_points = 0, n_inner = 0, n_outer = 0;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i, ++n_points)
                points +=
                    fmt::format("({} {} {})\n", box.min.x() + size * i, box.min.y() + size * j, box.min.z() + size * k);
    const auto face = [&](int own, int next, int a, int b, int c, int d) {
        const std::string text = fmt::format("4({} {} {} {})\n", a, b, c, d);
        if (next >= 0)
            inner += text, owner += fmt::format("{}\n", own), neighbour += fmt::format("{}\n", next), ++n_inner;
        else
            outer += text, outer_owner += fmt::format("{}\n", own), ++n_outer;
    };
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const int own = cell(i, j, k);
                const auto p = [&](int a, int b, int c) { return point(i + a, j + b, k + c); };
                face(own, i + 1 < nx ? cell(i + 1, j, k) : -1, p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1));
                face(own, j + 1 < ny ? cell(i, j + 1, k) : -1, p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
                face(own, k + 1 < nz ? cell(i, j, k + 1) : -1, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
                if (i == 0) face(own, -1, p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));
                if (j == 0) face(own, -1, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
                if (k == 0) face(own, -1, p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0));
                const double z = box.min.z() + size * (k + 0.5), wind = 8 * std::tanh(std::max(0.0, z) / 5);
                u += fmt::format("({} {} 0)\n", wind * std::cos(0.02 * z), wind * std::sin(0.02 * z));
            }
    put("constant/polyMesh/points", "vectorField", list(n_points, points));
    put("constant/polyMesh/faces", "faceList", list(n_inner + n_outer, inner + outer));
    put("constant/polyMesh/owner", "labelList", list(n_inner + n_outer, owner + outer_owner));
    put("constant/polyMesh/neighbour", "labelList", list(n_inner, neighbour));
    put("constant/polyMesh/boundary", "polyBoundaryMesh",
        fmt::format("1\n(\nsides {{ type patch; nFaces {}; startFace {}; }}\n)\n", n_outer, n_inner));
    std::filesystem::create_directories(folder / "0");
    put("1/U", "volVectorField",
        fmt::format("dimensions [0 1 -1 0 0 0 0];\ninternalField nonuniform List<vector> {}(\n{});\n"
                    "boundaryField {{ sides {{ type zeroGradient; }} }}\n",
                    static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz), u));
}

void row(const char* name, std::span<const Droplet> droplets, const Air& air, std::span<const Target> targets) {
    FlightOptions o;
    o.falls_back = false;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();  // of all threads
    const auto landings = fly(droplets, air, targets, o);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::size_t hits = 0, left = 0;
    for (const Landing& l : landings) hits += l.fate == Fate::hit, left += l.fate == Fate::left_air;
    const double work = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {} | {} |\n", name, droplets.size(), wall, work,
               1e6 * work / static_cast<double>(droplets.size()), hits, left);
}

}  // namespace

int main(int argc, char** argv) {
    const auto droplets = fountain(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000);
    const UniformAir uniform{AirState{}};
    const AirTable table({{-1000, {}}, {0, {}}, {1, {{3, 0, 0}}}, {3, {{5, 0, 0}}}, {1000, {{8, 0, 0}}}});
    const FirstHit surface(disc({2, 0, 1}, 0.5));
    const Target target{"disc", &surface};
    fmt::print("1 s of flight, tolerance 1e-6, {} threads\n\n", omp_get_max_threads());
    fmt::print(
        "| air and targets | droplets | wall [s] | processor [s] | per droplet [us] | hits | left the air "
        "|\n|---|---|---|---|---|---|---|\n");
    row("uniform", droplets, uniform, {});
    row("table over z", droplets, table, {});
    row("uniform, disc", droplets, uniform, {&target, 1});
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        fmt::format("bench_spray_{}", std::chrono::steady_clock::now().time_since_epoch().count());
    for (const double size : {4.0, 1.0}) {
        write_block(folder, {{-44, -44, -12}, {44, 44, 44}}, size);
        const auto begin = std::chrono::steady_clock::now();
        const FoamAir field(folder, 1, {});
        const double reading = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        row(fmt::format("OpenFOAM, cubes of {} m, read in {:.1f} s", size, reading).c_str(), droplets, field, {});
        std::filesystem::remove_all(folder);
    }
}
