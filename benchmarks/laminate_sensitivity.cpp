// How far the answers of the slamming study's laminate depend on what the study does not print: the constants and
// thicknesses of its plies. Lowest frequency, deflection of the centre and strain of the gauge 30 mm from it under a
// static pressure of 10 kPa, edges clamped, each assumed number 20 % lower and higher. Without water. Then how far the
// linear plate can be believed: the same under lower pressures, with large rotations.
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <numbers>

#include "structure/equilibrium.h"
#include "structure/generate.h"
#include "structure/modes.h"
#include "structure/shell/corotational.h"
#include "structure/shell/gauge.h"

using namespace tw;
using namespace tw::structure;

namespace {

/// The assumptions: carbon fabric (C1) and unidirectional carbon tape (C2) of the usual order of magnitude.
struct Assumed {
    double fabric_E = 60e9, tape_E1 = 125e9, tape_E2 = 8.5e9, G = 4.5e9, fabric_t = 0.28e-3, tape_t = 0.16e-3;
};

struct Answers {
    double hertz, deflection, strain;
};

Shell plate_of(const Assumed& a) {
    const PlyMaterial fabric{a.fabric_E, a.fabric_E, 0.05, a.G, a.G, a.G, 1550};
    const PlyMaterial tape{a.tape_E1, a.tape_E2, 0.3, a.G, a.G, a.G, 1550};
    return Shell(plate_mesh(0.4, 0.4, 40, 40),
                 Laminate(read_layup("[45 C1/0 C2/45 C2/90 C2]s",
                                     {{"C1", {fabric, 0, a.fabric_t}}, {"C2", {tape, 0, a.tape_t}}})));
}

GaugeReader gauge_of(const Shell& plate) { return {plate, {.name = "r = 30 mm", .position = Vec3(0.23, 0.2, 0)}}; }
constexpr int middle = 6 * (20 * 41 + 20) + 2;  // deflection of the centre

Answers answers(const Assumed& a) {
    const Shell plate = plate_of(a);
    DegreesOfFreedom dofs(plate.mesh().nodes, 6);
    dofs.clamp(plate.mesh().sets.at("edges"));
    const SparseMatrix T = dofs.basis(), K = T.transpose() * plate.stiffness() * T,
                       M = T.transpose() * dofs.mass(plate.mass()) * T;
    const Eigen::VectorXd load = plate.pressure_load(Eigen::VectorXd::Constant(1600, -1e4));
    const Eigen::VectorXd u = T * Eigen::SimplicialLDLT<SparseMatrix>(K).solve(T.transpose() * load);
    return {lowest_modes(K, M, 1).omega[0] / (2 * std::numbers::pi), u[middle], gauge_of(plate).strain(u)};
}
/// The linear plate and the one with large rotations under rising pressure.
void print_large_rotations() {
    const Shell plate = plate_of({});
    const Corotational turning(plate);
    const GaugeReader gauge = gauge_of(plate);
    DegreesOfFreedom dofs(plate.mesh().nodes, 6);
    dofs.clamp(plate.mesh().sets.at("edges"));
    const SparseMatrix T = dofs.basis(), K = T.transpose() * plate.stiffness() * T;
    const Eigen::SimplicialLDLT<SparseMatrix> linear(K);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(plate.dofs());
    for (const double p : {100.0, 300.0, 1000.0, 3000.0, 10000.0}) {
        const Eigen::VectorXd load = plate.pressure_load(Eigen::VectorXd::Constant(1600, -p));
        const Eigen::VectorXd small = T * linear.solve(T.transpose() * load);
        u = equilibrium(
            u, T,
            {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd { return load - turning.internal_force(at); },
             [&](const Eigen::VectorXd& at) { return turning.tangent(at); },
             [&](const Eigen::VectorXd& at, const Eigen::VectorXd& by) { return turning.moved(at, by); }},
            1e-6 * load.norm());
        const double strain = gauge.strain(turning.deformation(u, gauge.element()));
        fmt::print("{:6.0f} Pa: centre {:.2f} mm, linear {:.2f} mm; strain {:.0f}e-6, linear {:.0f}e-6\n", p,
                   1e3 * u[middle], 1e3 * small[middle], 1e6 * strain, 1e6 * gauge.strain(small));
    }
}
}  // namespace

int main() {
    const Answers base = answers({});
    fmt::print("as assumed: {:.2f} Hz, centre {:.2f} mm, strain {:.0f}e-6\n", base.hertz, 1e3 * base.deflection,
               1e6 * base.strain);
    const std::pair<const char*, double Assumed::*> numbers[] = {
        {"E of the fabric", &Assumed::fabric_E},         {"E1 of the tape", &Assumed::tape_E1},
        {"E2 of the tape", &Assumed::tape_E2},           {"shear moduli", &Assumed::G},
        {"thickness of the fabric", &Assumed::fabric_t}, {"thickness of the tape", &Assumed::tape_t}};
    for (const auto& [name, number] : numbers)
        for (const double factor : {0.8, 1.2}) {
            Assumed a;
            a.*number *= factor;
            const Answers other = answers(a);
            fmt::print("{:24} {:+.0f} %: frequency {:+.1f} %, centre {:+.1f} %, strain {:+.1f} %\n", name,
                       100 * (factor - 1), 100 * (other.hertz / base.hertz - 1),
                       100 * (other.deflection / base.deflection - 1), 100 * (other.strain / base.strain - 1));
        }
    print_large_rotations();
}
