#include "sph_solver/state/checkpoint.h"

#include <fmt/format.h>

#include <stdexcept>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/checksum_line.h"
#include "record/hdf5_file.h"

namespace tw {

namespace {

constexpr double version = 3;  // 2: without the checksum line
constexpr const char* bodies_group = "bodies";
/// Births and deaths at the edge between levels k and k + 1.
std::string edge_name(std::size_t k) { return fmt::format("edge_{}", k); }

hid_t type_of(const AnyField& field) {
    switch (field.element()) {
        case AnyField::Element::float64: return H5T_NATIVE_DOUBLE;
        case AnyField::Element::float32: return H5T_NATIVE_FLOAT;
        case AnyField::Element::int64: return H5T_NATIVE_INT64;
        case AnyField::Element::uint8: return H5T_NATIVE_UINT8;
        case AnyField::Element::record: break;
    }
    throw std::logic_error(std::string(field.name()) + ": checkpoints hold numbers only");
}

void write_level(hid_t at, const Level& level) {
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
    const Particles& particles = level.particles();
    particles.each([&](const AnyField& field) {
        if (!field.saved() || !particles.has(field.with())) return;
        const hsize_t n = field.length();
        h5::write_array(at, field.name(), type_of(field), field.raw(), {&n, 1}, false);
    });
}

Checkpoint::OfLevel read_level(hid_t at) {
    Checkpoint::OfLevel level;
    level.material = h5::read_text_attribute(at, "material");
    Level::State& s = level.state;
    const auto state = h5::read_numbers_attribute(at, "state"), counts = h5::read_numbers_attribute(at, "counts");
    if (state.size() != 6 || counts.size() != 6) throw h5::Failure{"its state is not whole"};
    s.time = state[0], s.dt = state[1];
    s.extremes.speed = state[2], s.extremes.acceleration = state[3], s.extremes.density_deviation_low = state[4],
    s.extremes.density_deviation_high = state[5];
    const auto whole = [&](std::size_t k) { return static_cast<std::int64_t>(counts[k]); };
    s.steps = whole(0), s.ledger = {whole(1), whole(2), whole(3), whole(4), whole(5)};
    Particles& particles = level.particles;
    particles.each([&](AnyField& field) {
        if (!field.saved() || (field.with() != With::water && !h5::has(at, field.name()))) return;
        const auto dims = h5::dimensions(at, field.name());
        if (dims.size() != 1) throw h5::Failure{std::string(field.name()) + " is not a list"};
        field.set_length(dims[0]);
        if (field.length() != particles.size())
            throw h5::Failure{std::string(field.name()) + " has another length than x"};
        h5::read_array(at, field.name(), type_of(field), field.raw(), field.length());
    });
    return level;
}

void write_control_volume(hid_t at, const ControlVolume::State& s) {
    const double sums[] = {s.crossed.x(), s.crossed.y(), s.crossed.z(), s.impulse.x(),
                           s.impulse.y(), s.impulse.z(), s.since};
    h5::write_attribute(at, "sums", std::span<const double>(sums));
}

ControlVolume::State read_control_volume(hid_t at) {
    const auto sums = h5::read_numbers_attribute(at, "sums");
    if (sums.size() != 7) throw h5::Failure{"the control volume's sums are not whole"};
    return {Vec3(sums[0], sums[1], sums[2]), Vec3(sums[3], sums[4], sums[5]), sums[6]};
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const std::string& run_hash, const Simulation& simulation,
                      double mass_at_start) {
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
            write_level(h5::create_group(levels, std::to_string(k).c_str()), simulation.level(k));
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

Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& run_hash) {
    if (!std::filesystem::is_regular_file(path))
        throw InputError(path.string() + ": there is no such file; start the run anew with --overwrite");
    const Bytes bytes = judge_bytes(read_text(path));
    try {
        const h5::Silence silence;
        const h5::Handle file(
            h5::checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "not an HDF5 file, or cut off"), H5Fclose);
        if (!h5::has_attribute(file, "twinwake_checkpoint")) throw h5::Failure{"not a checkpoint"};
        const auto written = h5::read_numbers_attribute(file, "twinwake_checkpoint");
        if (written.size() != 1 || !(written[0] >= 1)) throw h5::Failure{"damaged: its format is no number from 1 on"};
        if (written[0] != version)
            throw h5::Failure{
                fmt::format("a checkpoint of format {}, by {} version of twinwake; this one resumes from "
                            "format {}",
                            written[0], written[0] < version ? "an earlier" : "a later", version)};
        Checkpoint c;
        const h5::Handle own = h5::open_group(file, "simulation");
        if (h5::read_text_attribute(own, "run_hash") != run_hash)
            throw InputError(path.string() +
                             ": belongs to another scene (or the scene file was changed); run in another folder or "
                             "with --overwrite");
        c.isa = h5::read_text_attribute(own, "isa");
        const auto mass = h5::read_numbers_attribute(own, "mass_at_start");
        if (mass.size() != 1) throw h5::Failure{"its mass at the start is missing"};
        c.mass_at_start = mass[0];
        const h5::Handle levels = h5::open_group(file, "levels");
        for (std::size_t k = 0; h5::has(levels, std::to_string(k).c_str()); ++k)
            c.levels.push_back(read_level(h5::open_group(levels, std::to_string(k).c_str())));
        for (std::size_t k = 0; h5::has_attribute(levels, edge_name(k).c_str()); ++k) {
            const auto counts = h5::read_numbers_attribute(levels, edge_name(k).c_str());
            if (counts.size() != 2) throw h5::Failure{"the births and deaths of its levels are not whole"};
            c.edges.push_back({static_cast<std::int64_t>(counts[0]), static_cast<std::int64_t>(counts[1])});
        }
        if (c.levels.empty()) throw h5::Failure{"it holds no level of particles"};
        if (h5::has(file, "control_volume")) c.control = read_control_volume(h5::open_group(file, "control_volume"));
        if (h5::has(file, bodies_group)) {
            const h5::Handle bodies = h5::open_group(file, bodies_group);
            for (std::size_t k = 0; h5::has(bodies, std::to_string(k).c_str()); ++k)
                c.bodies.push_back(h5::read_vector<double>(bodies, std::to_string(k).c_str(), H5T_NATIVE_DOUBLE));
        }
        if (bytes != Bytes::whole) throw h5::Failure{"damaged: its bytes do not fit their checksum"};
        return c;
    } catch (const h5::Failure& f) {
        throw InputError(path.string() + ": cannot be resumed from: " + f.what + "; start anew with --overwrite");
    }
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
