#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "record/hdf5_file.h"
#include "spray/extract/read_frames.h"

namespace tw::spray {
namespace fs = std::filesystem;
namespace {

double time_of(hid_t root) {
    const h5::Handle field_data = h5::open_group(root, "FieldData");
    const auto time = h5::read_vector<double>(field_data, "TimeValue", H5T_NATIVE_DOUBLE);
    if (time.size() != 1 || !std::isfinite(time[0])) throw h5::Failure{"FieldData/TimeValue: not one time"};
    return time[0];
}

/// Opens a snapshot and hands its group VTKHDF to `read`; HDF5's failures become InputError with the file's name.
template <class Read>
auto with_snapshot(const fs::path& file, Read read) {
    const h5::Silence silence;
    try {
        const h5::Handle opened(h5::checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "opening it"),
                                H5Fclose);
        const h5::Handle root = h5::open_group(opened, "VTKHDF");
        return read(root);
    } catch (const h5::Failure& f) {
        throw InputError(file.string() + ": cannot be read as a snapshot of particles: " + f.what);
    }
}

}  // namespace

std::vector<FrameFile> particle_frames(const fs::path& run, const FrameRange& range) {
    const fs::path folder = fs::is_directory(run / "snapshots") ? run / "snapshots" : run;
    if (!fs::is_directory(folder))
        throw InputError(run.string() + ": no such folder; expected RUN/sph of a finished run");
    std::vector<FrameFile> frames;
    std::size_t there = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("particles_") || !name.ends_with(".hdf")) continue;
        ++there;
        const double time = with_snapshot(entry.path(), [](hid_t root) { return time_of(root); });
        if (time >= range.from && time <= range.to) frames.push_back({time, entry.path()});
    }
    if (there == 0)
        throw InputError(run.string() +
                         ": no particles_*.hdf there; expected snapshots of a particle run: [sampling] snapshots = "
                         "\"0.02 s\" in its scene");
    if (frames.empty())
        throw InputError(fmt::format("{}: none of its {} snapshots lies between {:g} and {:g} s", run.string(), there,
                                     range.from, range.to));
    std::ranges::sort(frames, {}, &FrameFile::time);
    return frames;
}

WaterFrame read_particles(const FrameFile& from) {
    WaterFrame frame;
    frame.time = from.time;
    with_snapshot(from.file, [&](hid_t root) {
        const auto count = h5::read_vector<long long>(root, "NumberOfPoints", H5T_NATIVE_LLONG);
        if (count.size() != 1 || count[0] < 0) throw h5::Failure{"NumberOfPoints: not one number"};
        const auto n = static_cast<std::size_t>(count[0]);
        std::vector<float> places(3 * n), velocities(3 * n), spacing(n);
        h5::read_array(root, "Points", H5T_NATIVE_FLOAT, places.data(), 3 * n);
        const h5::Handle data = h5::open_group(root, "PointData");
        h5::read_array(data, "velocity", H5T_NATIVE_FLOAT, velocities.data(), 3 * n);
        h5::read_array(data, "spacing", H5T_NATIVE_FLOAT, spacing.data(), n);
        frame.elements.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            Element& e = frame.elements[i];
            for (std::size_t k = 0; k < 3; ++k) {
                e.place[static_cast<Eigen::Index>(k)] = places[3 * i + k];
                e.velocity[static_cast<Eigen::Index>(k)] = velocities[3 * i + k];
            }
            e.size = spacing[i];
            e.volume = e.size * e.size * e.size;
        }
        return 0;
    });
    const auto same_y = [&](const Element& e) { return e.place.y() == frame.elements.front().place.y(); };
    if (frame.elements.size() > 1 && std::ranges::all_of(frame.elements, same_y))
        throw InputError(from.file.string() + ": a run in two dimensions has no droplets; expected three");
    return frame;
}

WaterFrame mirrored(WaterFrame frame) {
    const std::size_t n = frame.elements.size();
    frame.elements.reserve(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
        Element other = frame.elements[i];
        other.place.y() = -other.place.y();
        other.velocity.y() = -other.velocity.y();
        frame.elements.push_back(other);
    }
    return frame;
}

}  // namespace tw::spray
