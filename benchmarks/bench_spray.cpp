#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <random>

#include "spray/flight/fly.h"

// Throughput of the droplets' flight: bench_spray [droplets] prints a table. Droplets of 0.2 to 5 mm leave a place in
// all directions upward at 5 to 40 m/s and fly for one second; once in uniform air, once in a table over z, once towards
// a disc of 4800 triangles.

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

void row(const char* name, std::span<const Droplet> droplets, const Air& air, std::span<const Target> targets) {
    FlightOptions o;
    o.falls_back = false;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();  // of all threads
    const auto landings = fly(droplets, air, targets, o);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::size_t hits = 0;
    for (const Landing& l : landings) hits += l.fate == Fate::hit;
    const double work = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {} |\n", name, droplets.size(), wall, work,
               1e6 * work / static_cast<double>(droplets.size()), hits);
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
        "| air and targets | droplets | wall [s] | processor [s] | per droplet [us] | hits "
        "|\n|---|---|---|---|---|---|\n");
    row("uniform", droplets, uniform, {});
    row("table over z", droplets, table, {});
    row("uniform, disc", droplets, uniform, {&target, 1});
}
