#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <new>
#include <stdexcept>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/trial.h"
#include "record/checksum_line.h"
#include "record/hdf5_file.h"
#include "sph_solver/state/checkpoint.h"
#include "sph_solver/state/checkpoint_layout.h"

namespace tw {
namespace {

namespace fs = std::filesystem;
using namespace checkpoint_layout;

std::int64_t whole(double number) {
    constexpr double most = 0x1p53;  // up to which a double is exact
    if (!(std::abs(number) <= most)) throw h5::Failure{"a count in it is no whole number"};
    return static_cast<std::int64_t>(number);
}

Checkpoint::OfLevel read_level(hid_t at, bool with_particles) {
    Checkpoint::OfLevel level;
    level.material = h5::read_text_attribute(at, "material");
    Level::State& s = level.state;
    const auto state = h5::read_numbers_attribute(at, "state"), counts = h5::read_numbers_attribute(at, "counts");
    if (state.size() != 6 || counts.size() != 6) throw h5::Failure{"its state is not whole"};
    s.time = state[0], s.dt = state[1];
    s.extremes.speed = state[2], s.extremes.acceleration = state[3], s.extremes.density_deviation_low = state[4],
    s.extremes.density_deviation_high = state[5];
    s.steps = whole(counts[0]);
    s.ledger = {whole(counts[1]), whole(counts[2]), whole(counts[3]), whole(counts[4]), whole(counts[5])};
    Particles& particles = level.particles;
    particles.each([&](AnyField& field) {
        if (!with_particles || !field.saved() || (field.with() != With::water && !h5::has(at, field.name()))) return;
        const auto dims = h5::dimensions(at, field.name());
        if (dims.size() != 1) throw h5::Failure{std::string(field.name()) + " is not a list"};
        field.set_length(dims[0]);
        if (field.length() != particles.size())
            throw h5::Failure{std::string(field.name()) + " has another length than x"};
        h5::read_array(at, field.name(), type_of(field), field.raw(), field.length());
    });
    return level;
}

ControlVolume::State read_control_volume(hid_t at) {
    const auto sums = h5::read_numbers_attribute(at, "sums");
    if (sums.size() != 7) throw h5::Failure{"the control volume's sums are not whole"};
    return {Vec3(sums[0], sums[1], sums[2]), Vec3(sums[3], sums[4], sums[5]), sums[6]};
}

/// Throws h5::Failure; InputError where it is another scene's.
Checkpoint contents(const fs::path& path, const std::string& run_hash, bool with_particles) {
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
        c.levels.push_back(read_level(h5::open_group(levels, std::to_string(k).c_str()), with_particles));
    for (std::size_t k = 0; h5::has_attribute(levels, edge_name(k).c_str()); ++k) {
        const auto counts = h5::read_numbers_attribute(levels, edge_name(k).c_str());
        if (counts.size() != 2) throw h5::Failure{"its counts of split and merged particles are not whole numbers"};
        c.edges.push_back({whole(counts[0]), whole(counts[1])});
    }
    if (c.levels.empty()) throw h5::Failure{"it holds no level of particles"};
    if (h5::has(file, "control_volume")) c.control = read_control_volume(h5::open_group(file, "control_volume"));
    if (h5::has(file, bodies_group)) {
        const h5::Handle bodies = h5::open_group(file, bodies_group);
        for (std::size_t k = 0; h5::has(bodies, std::to_string(k).c_str()); ++k)
            c.bodies.push_back(h5::read_vector<double>(bodies, std::to_string(k).c_str(), H5T_NATIVE_DOUBLE));
    }
    return c;
}

/// What is wrong with a file that is not as it was written. It is read in a child, as HDF5 follows what stands in it.
std::string fault(const fs::path& path, const std::string& run_hash) {
    try {
        const std::string words = answer_of_trial([&]() -> std::string {
            try {
                contents(path, run_hash, true);
            } catch (const h5::Failure& f) { return f.what; } catch (const InputError&) {
            }
            return {};
        });
        return words.empty() ? "damaged: its bytes do not fit their checksum" : words;
    } catch (const InputError& e) { return std::string("damaged: ") + e.what(); }
}

}  // namespace

Checkpoint read_checkpoint(const fs::path& path, const std::string& run_hash, bool with_particles) {
    if (!fs::is_regular_file(path))
        throw InputError(path.string() + ": there is no such file; start the run anew with --overwrite");
    std::string why;
    try {
        if (!with_particles || judge_bytes(read_text(path)) == Bytes::whole)
            return contents(path, run_hash, with_particles);
        why = fault(path, run_hash);
    } catch (const h5::Failure& f) { why = f.what; } catch (const std::bad_alloc&) {
        why = "an array in it claims more than the memory holds";
    } catch (const std::length_error&) { why = "an array in it claims a senseless size"; }
    throw InputError(path.string() + ": cannot be resumed from: " + why + "; start anew with --overwrite");
}

}  // namespace tw
