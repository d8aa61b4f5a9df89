#include "sph_solver/state/checkpoint.h"

#include <fmt/format.h>

#include <utility>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/checksum_line.h"
#include "record/hdf5_file.h"
#include "sph_solver/all_particles.h"
#include "sph_solver/state/checkpoint_layout.h"

namespace tw {

namespace {

using namespace checkpoint_layout;

/// Each quantity is let go when it is written: the file is made in memory.
void write_level(hid_t at, Checkpoint::OfLevel& level) {
    const Level::State& s = level.state;
    const double state[] = {s.time,
                            s.dt,
                            s.extremes.speed,
                            s.extremes.acceleration,
                            s.extremes.density_deviation_low,
                            s.extremes.density_deviation_high};
    const long long counts[] = {s.steps, s.ledger.in, s.ledger.out, s.ledger.lost, s.ledger.held, s.ledger.next_id};
    h5::write_attribute(at, "material", level.material);
    h5::write_attribute(at, "state", std::span<const double>(state));
    h5::write_attribute(at, "counts", std::span<const long long>(counts));
    level.particles.each([&](AnyField& field) {
        if (!field.saved() || !level.particles.has(field.with())) return;
        const hsize_t n = field.length();
        h5::write_array(at, field.name(), type_of(field), std::as_const(field).raw(), {&n, 1}, false);
        field.let_go();
    });
}

void write_control_volume(hid_t at, const ControlVolume::State& s) {
    const double sums[] = {s.crossed.x(), s.crossed.y(), s.crossed.z(), s.impulse.x(),
                           s.impulse.y(), s.impulse.z(), s.since};
    h5::write_attribute(at, "sums", std::span<const double>(sums));
}

}  // namespace

Checkpoint checkpoint_of(const Simulation& simulation, double mass_at_start) {
    const AllParticles particles(simulation);
    Checkpoint c;
    c.isa = simulation.passes().isa;
    c.mass_at_start = mass_at_start;
    for (std::size_t k = 0; k < simulation.levels().size(); ++k) {
        const Level& level = simulation.level(k);
        Checkpoint::OfLevel& saved = c.levels.emplace_back();
        saved.material = level.system().setup.material;
        saved.state = level.state();
        saved.particles.copy_saved_of(particles.of(k));
    }
    for (const Refinement& refinement : simulation.refinements())
        c.edges.push_back({refinement.ledger().splits, refinement.ledger().merges});
    if (const ControlVolume* control = simulation.control_volume()) c.control = control->state();
    for (const auto& body : simulation.bodies())
        if (!body->fixed()) c.bodies.push_back(body->state());
    return c;
}

void write_checkpoint(const std::filesystem::path& path, const std::string& run_hash, Checkpoint checkpoint) {
    try {
        const h5::Silence silence;
        const h5::Handle file = h5::create_in_memory();
        h5::write_attribute(file, "twinwake_checkpoint", version);
        {
            const h5::Handle own = h5::create_group(file, "simulation");
            h5::write_attribute(own, "run_hash", run_hash);
            h5::write_attribute(own, "isa", checkpoint.isa);
            h5::write_attribute(own, "mass_at_start", checkpoint.mass_at_start);
        }
        const h5::Handle levels = h5::create_group(file, "levels");
        for (std::size_t k = 0; k < checkpoint.levels.size(); ++k)
            write_level(h5::create_group(levels, std::to_string(k).c_str()), checkpoint.levels[k]);
        for (std::size_t k = 0; k < checkpoint.edges.size(); ++k) {
            const long long counts[] = {checkpoint.edges[k].splits, checkpoint.edges[k].merges};
            h5::write_attribute(levels, edge_name(k).c_str(), std::span<const long long>(counts));
        }
        if (checkpoint.control) write_control_volume(h5::create_group(file, "control_volume"), *checkpoint.control);
        if (!checkpoint.bodies.empty()) {
            const h5::Handle bodies = h5::create_group(file, bodies_group);
            for (std::size_t b = 0; b < checkpoint.bodies.size(); ++b)
                h5::write_vector(bodies, std::to_string(b).c_str(), H5T_NATIVE_DOUBLE, checkpoint.bodies[b], false);
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
        if (checkpoint.levels[k].material != simulation.level(k).system().setup.material)
            throw InputError(
                fmt::format("level {} of the checkpoint is {}, the scene's is {}; start anew with "
                            "--overwrite",
                            k, checkpoint.levels[k].material, simulation.level(k).system().setup.material));
    simulation.level(0).system().ranks().on_first([&] {
        for (std::size_t k = 0; k < levels; ++k) {
            const Particles& p = checkpoint.levels[k].particles;
            p.each([&](const AnyField& field) {
                if (field.saved() && simulation.level(k).fields().particles().has(field.with()) &&
                    field.length() != p.size())
                    throw InputError(
                        "the checkpoint was written by an earlier version of twinwake; start anew with --overwrite");
            });
        }
    });
    if (checkpoint.edges.size() != simulation.refinements().size())
        throw InputError("the checkpoint's water has another number of particle sizes; start anew with --overwrite");
    for (std::size_t k = 0; k < checkpoint.edges.size(); ++k)
        simulation.refinements()[k].set_ledger({checkpoint.edges[k].splits, checkpoint.edges[k].merges});
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
    if (ControlVolume* control = simulation.control_volume())
        control->set_state(checkpoint.control.value_or(ControlVolume::State{}));
    simulation.follow_bodies();
}

}  // namespace tw
