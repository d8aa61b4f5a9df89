#include "sph_solver/state/checkpoint.h"

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/hdf5_file.h"

namespace tw {

namespace {
constexpr double version = 1;

/// The arrays of the particles under their names, the same list for writing and reading.
template <class P, class Function>
void for_each_named(P& p, Function f) {
    f("x", H5T_NATIVE_DOUBLE, p.x), f("y", H5T_NATIVE_DOUBLE, p.y), f("z", H5T_NATIVE_DOUBLE, p.z);
    f("u", H5T_NATIVE_FLOAT, p.u), f("v", H5T_NATIVE_FLOAT, p.v), f("w", H5T_NATIVE_FLOAT, p.w);
    f("drho", H5T_NATIVE_FLOAT, p.drho), f("id", H5T_NATIVE_INT64, p.id), f("kind", H5T_NATIVE_UINT8, p.kind);
}

void write_state(hid_t at, const Solver& solver, double mass_at_start) {
    const Solver::Restart r = solver.restart_state();
    const double state[] = {r.time,
                            r.dt,
                            r.extremes.speed,
                            r.extremes.acceleration,
                            r.extremes.density_deviation_low,
                            r.extremes.density_deviation_high,
                            mass_at_start};
    const long long counts[] = {r.steps, r.next_id, r.ledger.in, r.ledger.out, r.ledger.lost, r.ledger.held};
    h5::write_attribute(at, "state", std::span<const double>(state));
    h5::write_attribute(at, "counts", std::span<const long long>(counts));
    for_each_named(solver.particles(), [&](const char* name, hid_t type, const auto& values) {
        h5::write_vector(at, name, type, values, false);
    });
}

void read_state(hid_t at, Solver::Restart& r, Particles& particles, double& mass_at_start) {
    const auto state = h5::read_numbers_attribute(at, "state"), counts = h5::read_numbers_attribute(at, "counts");
    if (state.size() != 7 || counts.size() != 6) throw h5::Failure{"its state is not whole"};
    r.time = state[0], r.dt = state[1];
    r.extremes.speed = state[2], r.extremes.acceleration = state[3], r.extremes.density_deviation_low = state[4],
    r.extremes.density_deviation_high = state[5];
    mass_at_start = state[6];
    const auto whole = [&](std::size_t k) { return static_cast<std::int64_t>(counts[k]); };
    r.steps = whole(0), r.next_id = whole(1), r.ledger = {whole(2), whole(3), whole(4), whole(5)};
    for_each_named(particles, [&](const char* name, hid_t type, auto& values) {
        values = h5::read_vector<typename std::remove_reference_t<decltype(values)>::value_type>(at, name, type);
        if (values.size() != particles.x.size()) throw h5::Failure{std::string(name) + " has another length than x"};
    });
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const std::string& run_hash, const Solver& solver,
                      double mass_at_start) {
    try {
        const h5::Silence silence;
        const h5::Handle file = h5::create_in_memory();
        h5::write_attribute(file, "twinwake_checkpoint", version);
        h5::write_attribute(file, "run_hash", run_hash);
        write_state(file, solver, mass_at_start);
        if (solver.air()) write_state(h5::create_group(file, "air"), *solver.air(), 0);
        write_text_atomically(path, h5::image(file));
    } catch (const h5::Failure& f) { throw RunError(path.string() + ": cannot be written: " + f.what); }
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& run_hash) {
    if (!std::filesystem::exists(path))
        throw InputError(path.string() +
                         ": not there: the run has not reached its first checkpoint; start it anew with --overwrite");
    try {
        const h5::Silence silence;
        const h5::Handle file(
            h5::checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "not an HDF5 file, or cut off"), H5Fclose);
        if (!h5::has_attribute(file, "twinwake_checkpoint")) throw h5::Failure{"not a checkpoint"};
        if (h5::read_text_attribute(file, "run_hash") != run_hash)
            throw InputError(path.string() +
                             ": belongs to another scene (or the scene file was changed); run in another folder or "
                             "with --overwrite");
        Checkpoint c;
        read_state(file, c.state, c.particles, c.mass_at_start);
        double no_mass = 0;
        if (h5::has(file, "air")) read_state(h5::open_group(file, "air"), c.air_state, c.air, no_mass);
        return c;
    } catch (const h5::Failure& f) {
        throw InputError(path.string() + ": cannot be resumed from: " + f.what + "; start anew with --overwrite");
    }
}

}  // namespace tw
