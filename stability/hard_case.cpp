#include "stability/hard_case.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.h"
#include "base/exact_sum.h"
#include "meshes/generate.h"
#include "record/recorded_checks.h"
#include "sph_solver/measure/validity_checks.h"
#include "sph_solver/simulation.h"

namespace tw {

namespace {

constexpr double g = 9.81;
constexpr double span = 6;                           ///< of the solids along y: the plane y = 0 sees no end [m]
constexpr double block_width = 2, block_height = 1;  ///< the water of an impact [m]
constexpr double depth = 1, tank_length = 3;         ///< [m]
constexpr double stream_depth = 0.6;
constexpr double draft = 0.1;  ///< of the plate's lower edge [m]

Surface moved(Surface s, const Vec3& by) {
    for (Vec3& p : s.points) p += by;
    return s;
}

/// Keel (or flat bottom) at the origin, upright sides of 0.3 m above the chines.
Surface section(double deadrise_deg) {
    if (deadrise_deg >= 1)
        return make_hull(
            "wedge",
            {{"width", 1}, {"span", span}, {"deadrise", deadrise_deg * std::numbers::pi / 180}, {"side_height", 0.3}});
    const Surface box = make_hull("box", {{"length", 1}, {"beam", span}, {"height", 0.3}});
    const Box at = box.bounds();
    return moved(box, Vec3(-(at.min.x() + at.max.x()) / 2, 0, -at.min.z()));
}

/// Bow up by the trim, the lower edge `draft` under still water.
Surface plate(double trim_deg) {
    Surface s = make_hull("box", {{"length", 1}, {"beam", span}, {"height", 0.4}});
    const double trim = trim_deg * std::numbers::pi / 180, middle = (s.bounds().min.x() + s.bounds().max.x()) / 2;
    for (Vec3& p : s.points) {
        const double x = p.x() - middle, z = p.z();
        p.x() = x * std::cos(trim) + z * std::sin(trim);
        p.z() = z * std::cos(trim) - x * std::sin(trim);
    }
    return moved(s, Vec3(0, 0, -draft - s.bounds().min.z()));
}

/// Of inlet and outlet from the middle of the plate [m]: eight coarse spacings and more from an edge between two sizes.
double ahead(const HardCase& c) { return c.zone > 0 ? 0.6 + (c.zone + 20) / c.spacings_per_m : 1; }
double behind(const HardCase& c) { return std::max(1.5, ahead(c)); }

/// Where particles of half the size are, through what is too near for coarser ones.
Zone zone_of(const HardCase& c, const SimulationSetup& s) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const double reach = c.zone * s.dp, clear = 16 * s.dp;
    Box box{Vec3(-reach, 0, 0), Vec3(reach, 0, 0)};
    if (c.kind != HardCaseKind::tank) {
        const Box solid = Body::of(s.bodies.front())->bounds();
        box = {solid.min - Vec3::Constant(reach), solid.max + Vec3::Constant(reach)};
    }
    box.min.y() = -endless, box.max.y() = box.max.z() = endless;
    if (box.min.z() < s.domain.min.z() + clear || c.kind == HardCaseKind::tank) box.min.z() = -endless;
    return Zone({box});
}

struct Start {
    SimulationSetup setup;
    std::vector<Fluid> fluid;  ///< of each size, coarsest first
    bool upwards = false;      ///< the water starts with the speed along +z
};

Start start_of(const HardCase& c) {
    Start start;
    SimulationSetup& s = start.setup;
    s.dimensions = 2;
    s.dp = 1 / c.spacings_per_m;
    s.h_over_dp = c.h_over_dp;
    s.cfl = c.cfl;
    s.state_equation.c0 = c.c0_over_speed * c.reference_speed();
    s.threads = 1;
    const double coarsest = c.zone > 0 ? 2 * s.dp : s.dp;
    const auto on_lattice = [&](double x) { return std::round(x / coarsest) * coarsest; };
    Box water;
    switch (c.kind) {
        case HardCaseKind::impact:
            s.domain = {Vec3(-8, -1, -4), Vec3(8, 1, 8)};
            s.bodies = {section(c.deadrise_deg)};
            water = {Vec3(-on_lattice(block_width / 2), 0, -on_lattice(block_height)),
                     Vec3(on_lattice(block_width / 2), 0, 0)};
            start.upwards = true;
            break;
        case HardCaseKind::stream: {
            Stream stream;
            stream.speed = c.speed;
            stream.ramp = 0.3 / c.speed;  // of length / speed, as scenes have it
            stream.buffer = std::ceil(2 * s.h_over_dp + 2) * coarsest;
            s.stream = stream;
            s.domain = {Vec3(-on_lattice(ahead(c)), -1, -on_lattice(stream_depth)), Vec3(on_lattice(behind(c)), 1, 2)};
            s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
            s.bodies = {plate(c.deadrise_deg)};
            water = s.domain;
            water.min.x() -= stream.buffer, water.max.x() += stream.buffer, water.max.z() = 0;
            break;
        }
        case HardCaseKind::tank:
            s.domain = {Vec3(-on_lattice(tank_length / 2), -1, -on_lattice(depth)),
                        Vec3(on_lattice(tank_length / 2), 1, 1)};
            s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
            water = s.domain;
            water.max.z() = 0;
            break;
    }
    if (c.zone > 0) s.zones = {zone_of(c, s)};
    start.fluid = fill_levels(s, {water});
    if (start.upwards)  // in free flight: no pressure
        for (Fluid& fluid : start.fluid) std::ranges::fill(fluid.depth, 0.0);
    return start;
}

/// Sum of `f(level, i)` over the particles that are the water of their place.
template <class Function>
double sum_over_water(const Simulation& simulation, Function&& f) {
    ExactSum sum;
    for (const auto& level : simulation.water())
        for (std::size_t i = 0; i < level->fields().particles().size(); ++i)
            if (is_active(level->fields().particles().kind[i])) sum += f(*level, i);
    return sum.value();
}

/// Kinetic, potential (z = 0) and elastic energy [J/m]. The last is what p = c0^2 (rho - rho0) does while it
/// compresses:
///
///   e = int p drho / rho^2 = c0^2 (ln(1 + d) - d / (1 + d)),   d = rho / rho0 - 1
///
/// d^2 / 2 alone is a tenth too much at a compression of 7 %: more than what these cases are allowed to make.
///
/// Of the coarsest particles, which are everywhere and have the finer ones' fields under their zone: counted by the
/// active ones of both sizes, water that crosses an edge row by row would swing by half a coarse row.
double energy_of(const Simulation& simulation) {
    const Particles& p = simulation.particles();
    const double c0 = simulation.setup().state_equation.c0, rho0 = simulation.setup().rho0;
    ExactSum sum;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double u = p.u[i], w = p.w[i], d = double(p.drho[i]) / rho0;
        sum += 0.5 * (u * u + w * w) + c0 * c0 * (std::log1p(d) - d / (1 + d)) + g * p.z[i];
    }
    return simulation.mass() * sum.value();
}

double mass_of(const Simulation& simulation) {
    return sum_over_water(simulation, [](const Level& level, std::size_t) { return level.system().mass; });
}

/// Kinetic energy over rho g H V.
double motion(const Simulation& simulation) {
    const double kinetic = sum_over_water(simulation, [](const Level& level, std::size_t i) {
        const Particles& p = level.fields().particles();
        return 0.5 * level.system().mass * (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]);
    });
    return kinetic / (g * depth * mass_of(simulation));
}

double pressure_error(const Simulation& simulation) {
    const double rho0 = simulation.setup().rho0,
                 squares = sum_over_water(simulation, [&](const Level&level, std::size_t i) {
                     return level.system().mass *
                            std::pow(level.fields().pressure(i) + rho0 * g * level.fields().particles().z[i], 2);
                 });
    return std::sqrt(squares / mass_of(simulation)) / (rho0 * g * depth);
}

}  // namespace

const char* to_string(HardCaseKind kind) {
    static constexpr const char* names[] = {"impact", "stream", "tank"};
    return names[static_cast<int>(kind)];
}

double HardCase::reference_speed() const { return kind == HardCaseKind::tank ? std::sqrt(2 * g * depth) : speed; }

double HardCase::duration() const {
    switch (kind) {
        case HardCaseKind::impact: return 1 / speed;                                   // the block's height
        case HardCaseKind::stream: return 2 * (ahead(*this) + behind(*this)) / speed;  // twice through
        case HardCaseKind::tank: return 40 * std::sqrt(depth / g);
    }
    return 0;
}

double HardCase::predicted_work() const {
    const double area = kind == HardCaseKind::impact   ? block_width * block_height
                        : kind == HardCaseKind::stream ? (ahead(*this) + behind(*this)) * stream_depth
                                                       : tank_length * depth;
    const double step = cfl * h_over_dp / spacings_per_m / ((c0_over_speed + 2) * reference_speed());
    return area * spacings_per_m * spacings_per_m * duration() / step * h_over_dp * h_over_dp;
}

HardCaseRun run_hard_case(const HardCase& c, const std::function<bool(double)>& go_on) {
    const auto began = std::chrono::steady_clock::now();
    RunRecord record;
    HardCaseRun run;
    const bool closed = c.kind != HardCaseKind::stream;
    try {
        Start start = start_of(c);
        Simulation simulation(std::move(start.setup), start.fluid);
        if (start.upwards)
            for (const auto& level : simulation.levels())
                std::ranges::fill(level->fields_to_set().w, static_cast<float>(c.speed));
        run.particles = static_cast<double>(simulation.particles().size());  // the coarsest are everywhere
        const double energy = energy_of(simulation),
                     kinetic = 0.5 * simulation.mass() * run.particles * c.speed * c.speed;
        const double scale = c.kind == HardCaseKind::tank ? std::abs(energy) : kinetic;
        while (simulation.time() < c.duration()) {
            if (go_on && simulation.steps() % 20 == 0 && !go_on(simulation.time())) {
                run.stopped = true;
                break;
            }
            simulation.step();
            run.time = simulation.time(), run.steps = static_cast<double>(simulation.steps());
            watch_stability(simulation, record);
            const Ledger& l = simulation.ledger();
            const double missing =
                run.particles + static_cast<double>(l.in - l.out) - static_cast<double>(simulation.particles().size());
            note_worst(record,
                       {"particles missing", "-", std::abs(missing) + (closed ? double(l.out) : 0), 0, run.time});
            if (closed)
                note_worst(record, {"energy made", "%", 100 * (energy_of(simulation) - energy) / scale, 1, run.time});
        }
        if (c.kind == HardCaseKind::tank && !run.stopped) {
            note_worst(record, {"motion of still water", "-", motion(simulation), 1e-6, run.time});
            note_worst(record, {"pressure error", "%", 100 * pressure_error(simulation), 5, run.time});
        }
    } catch (const RunError& e) { run.failure = e.what(); }
    run.lines = std::move(record.validity_checks);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return run;
}

}  // namespace tw
