#include "sph_solver/effects/air.h"

#include <cmath>

#include "sph_solver/backend/run_pass.h"
#include "sph_solver/effects/passes.h"
#include "sph_solver/solver.h"

namespace tw {

SolverSetup air_setup(SolverSetup s, const AirOptions& air) {
    s.name = "particle of air";
    s.rho0 = air.density;
    s.state_equation = {};
    s.state_equation.form = StateEquation::Form::tait;
    s.state_equation.c0 = air.sound_speed;
    s.state_equation.gamma = air.heat_capacities;
    s.largest_compression = 10,
    s.largest_rarefaction = 0.95;  // 33 and 0.015 atmospheres: beyond any scene, short of nonsense
    s.tension_control = true;
    s.effects = {};
    return s;
}

double gas_energy(const Solver& gas) {
    const SolverSetup& s = gas.setup();
    const Particles& p = gas.particles();
    const double gamma = s.state_equation.gamma, c2 = s.state_equation.c0 * s.state_equation.c0;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = 1 + double(p.drho[i]) / s.rho0;
        sum += 0.5 * (double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]) -
               s.gravity.z() * p.z[i] +
               c2 / gamma * (std::pow(x, gamma - 1) / (gamma - 1) + 1 / x - gamma / (gamma - 1));
    }
    return gas.mass() * sum;
}

void Interface::find_neighbours(const Passes& passes, const ColumnGrid& grid, const Quanta& quanta, const PhaseView& own,
                                const PhaseView& other, double reach) {
    groups_ = own.groups;
    const PlaceRecord* place = other.pass.place;
    lists_.build(passes, grid, quanta, {own.pass.place, &own.start, 0}, groups_,
                 {{place, &other.start, 0}, {place + other.count, &other.image_start, static_cast<int>(other.count)}},
                 {reach, reach, reach});
    std::erase_if(groups_, [](const Group& g) { return g.list.size == 0; });
    sums_.assign(own.count, {});
}

void Interface::meet(const Passes& passes, const PassData& own, const PassData& other) {
    run_pass(passes.meet_other_phase, LevelPairData{lists_.view(), &own, &other, sums_.data()}, groups_);
}

void Interface::press(const Passes& passes, const PassData& own, const PassData& other) const {
    run_pass(passes.press_other_phase, LevelPairData{lists_.view(), &own, &other, nullptr}, groups_);
}

std::size_t Interface::bytes() const {
    return lists_.bytes() + groups_.capacity() * sizeof(Group) + sums_.capacity() * sizeof(OtherSums);
}

}  // namespace tw
