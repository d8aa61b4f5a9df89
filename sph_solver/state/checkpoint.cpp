#include "sph_solver/state/checkpoint.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/checksum_line.h"
#include "record/hdf5_file.h"
#include "sph_solver/all_particles.h"
#include "sph_solver/state/checkpoint_layout.h"

namespace tw {

namespace {

using namespace checkpoint_layout;

void write_level(hid_t at, const Level& level, const Particles& particles) {
    const Level::State s = level.state();
    const double state[] = {s.time,
                            s.dt,
                            s.extremes.speed,
                            s.extremes.acceleration,
                            s.extremes.density_deviation_low,
                            s.extremes.density_deviation_high};
    const long long counts[] = {s.steps, s.ledger.in, s.ledger.out, s.ledger.lost, s.ledger.held, s.ledger.next_id};
    h5::write_attribute(at, "material", level.setup().material);
    h5::write_attribute(at, "state", std::span<const double>(state));
    h5::write_attribute(at, "counts", std::span<const long long>(counts));
    particles.each([&](const AnyField& field) {
        if (!field.saved() || !particles.has(field.with())) return;
        const hsize_t n = field.length();
        h5::write_array(at, field.name(), type_of(field), field.raw(), {&n, 1}, false);
    });
}

void write_control_volume(hid_t at, const ControlVolume::State& s) {
    const double sums[] = {s.crossed.x(), s.crossed.y(), s.crossed.z(), s.impulse.x(),
                           s.impulse.y(), s.impulse.z(), s.since};
    h5::write_attribute(at, "sums", std::span<const double>(sums));
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const std::string& run_hash, const Simulation& simulation,
                      double mass_at_start) {
    const Comm& ranks = simulation.level(0).ranks();
    const AllParticles particles(simulation);
    if (!ranks.first()) return;
    try {
        const h5::Silence silence;
        const h5::Handle file = h5::create_in_memory();
        h5::write_attribute(file, "twinwake_checkpoint", version);
        {
            const h5::Handle own = h5::create_group(file, "simulation");
            h5::write_attribute(own, "run_hash", run_hash);
            h5::write_attribute(own, "isa", std::string(simulation.passes().isa));
            h5::write_attribute(own, "mass_at_start", mass_at_start);
        }
        const h5::Handle levels = h5::create_group(file, "levels");
        for (std::size_t k = 0; k < simulation.levels().size(); ++k)
            write_level(h5::create_group(levels, std::to_string(k).c_str()), simulation.level(k), particles.of(k));
        for (std::size_t k = 0; k < simulation.refinements().size(); ++k) {
            const Refinement::Ledger& l = simulation.refinements()[k].ledger();
            const long long counts[] = {l.births, l.deaths};
            h5::write_attribute(levels, edge_name(k).c_str(), std::span<const long long>(counts));
        }
        if (const ControlVolume* control = simulation.control_volume())
            write_control_volume(h5::create_group(file, "control_volume"), control->state());
        std::size_t moving = 0;
        for (const auto& body : simulation.bodies()) {
            if (body->fixed()) continue;
            if (moving == 0) h5::create_group(file, bodies_group);
            h5::write_vector(h5::open_group(file, bodies_group), std::to_string(moving++).c_str(), H5T_NATIVE_DOUBLE,
                             body->state(), false);
        }
        write_text_atomically(path, with_checksum_line(h5::image(file)));
    } catch (const h5::Failure& f) { throw RunError(path.string() + ": cannot be written: " + f.what); }
}

void restore(Simulation& simulation, Checkpoint checkpoint) {
    const std::size_t levels = simulation.levels().size();
    if (checkpoint.levels.size() != levels)
        throw InputError(
            fmt::format("the checkpoint holds {} levels of particles, the scene makes {}; start anew with "
                        "--overwrite",
                        checkpoint.levels.size(), levels));
    for (std::size_t k = 0; k < levels; ++k)
        if (checkpoint.levels[k].material != simulation.level(k).setup().material)
            throw InputError(
                fmt::format("level {} of the checkpoint is {}, the scene's is {}; start anew with "
                            "--overwrite",
                            k, checkpoint.levels[k].material, simulation.level(k).setup().material));
    for (std::size_t k = 0; k < levels; ++k) {
        const Particles& p = checkpoint.levels[k].particles;
        p.each([&](const AnyField& field) {
            if (field.saved() && simulation.level(k).particles().has(field.with()) && field.length() != p.size())
                throw InputError(
                    "the checkpoint was written by an earlier version of twinwake; start anew with --overwrite");
        });
    }
    if (checkpoint.edges.size() != simulation.refinements().size())
        throw InputError("the checkpoint's water has another number of particle sizes; start anew with --overwrite");
    for (std::size_t k = 0; k < checkpoint.edges.size(); ++k)
        simulation.refinements()[k].set_ledger({checkpoint.edges[k].births, checkpoint.edges[k].deaths});
    std::vector<Body*> moving;
    for (const auto& body : simulation.bodies())
        if (!body->fixed()) moving.push_back(body.get());
    if (checkpoint.bodies.size() != moving.size())
        throw InputError("the checkpoint has another number of bodies that move; start anew with --overwrite");
    for (std::size_t b = 0; b < moving.size(); ++b) try {
            moving[b]->restore(checkpoint.bodies[b]);
        } catch (const std::invalid_argument& e) {
            throw InputError(
                fmt::format("body {} of the checkpoint is not the scene's: {}; start anew with --overwrite",
                            moving[b]->name(), e.what()));
        }
    for (std::size_t k = 0; k < levels; ++k)
        simulation.level(k).restore(checkpoint.levels[k].state, std::move(checkpoint.levels[k].particles));
    if (ControlVolume* control = simulation.control_volume()) control->set_state(checkpoint.control);
    simulation.follow_bodies();
}

}  // namespace tw
