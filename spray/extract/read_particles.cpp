#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/errors.h"
#include "base/trial.h"
#include "record/hdf5_file.h"
#include "spray/extract/read_frames.h"

namespace tw::spray {
namespace fs = std::filesystem;
namespace {

std::vector<double> time_of(hid_t root) {
    const h5::Handle field_data = h5::open_group(root, "FieldData");
    const auto time = h5::read_vector<double>(field_data, "TimeValue", H5T_NATIVE_DOUBLE);
    if (time.size() != 1 || !std::isfinite(time[0])) throw h5::Failure{"FieldData/TimeValue: not one time"};
    return time;
}

/// The numbers that `take` finds in a snapshot's group VTKHDF. In a child, as HDF5 follows what stands in a file, and a
/// snapshot has no checksum line. Throws InputError with the file's name.
template <class Number, class Take>
std::vector<Number> numbers_of(const fs::path& file, Take take) {
    std::error_code none;
    const double size = fs::exists(file, none) ? static_cast<double>(fs::file_size(file)) : 0;  // [bytes]
    constexpr double slowest = 1e7;                                                             // [bytes/s]
    std::string bytes;
    try {
        bytes = answer_of_trial(
            [&] {
                const h5::Silence silence;
                try {
                    const h5::Handle opened(
                        h5::checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "opening it"), H5Fclose);
                    const std::vector<Number> numbers = take(h5::open_group(opened, "VTKHDF"));
                    return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
                } catch (const h5::Failure& f) { throw InputError(f.what); }
            },
            {.seconds = 60 + size / slowest, .bytes = 4e9 + 20 * size});
    } catch (const InputError& e) {
        throw InputError(file.string() + ": cannot be read as a snapshot of particles: " + e.what());
    }
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
    return numbers;
}

void take_array(hid_t group, const char* name, std::size_t width, std::size_t count, std::vector<float>& into) {
    std::size_t there = 1;
    for (const hsize_t d : h5::dimensions(group, name)) there *= d;
    if (there != width * count)
        throw h5::Failure{std::string(name) + " does not have as many values as there are points"};
    const std::size_t before = into.size();
    into.resize(before + there);
    h5::read_array(group, name, H5T_NATIVE_FLOAT, into.data() + before, there);
}

/// Of all particles their places, then their velocities, then their spacings.
std::vector<float> particles_in(hid_t root) {
    const auto count = h5::read_vector<long long>(root, "NumberOfPoints", H5T_NATIVE_LLONG);
    if (count.size() != 1 || count[0] < 0 || count[0] > (1LL << 40))
        throw h5::Failure{"NumberOfPoints: no number of points"};
    const auto n = static_cast<std::size_t>(count[0]);
    const h5::Handle data = h5::open_group(root, "PointData");
    std::vector<float> numbers;
    take_array(root, "Points", 3, n, numbers);
    take_array(data, "velocity", 3, n, numbers);
    take_array(data, "spacing", 1, n, numbers);
    return numbers;
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
        const double time = numbers_of<double>(entry.path(), time_of).at(0);
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
    const std::vector<float> numbers = numbers_of<float>(from.file, particles_in);
    const std::size_t n = numbers.size() / 7;
    frame.elements.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        Element& e = frame.elements[i];
        const float *place = &numbers[3 * i], *velocity = &numbers[3 * (n + i)];
        e.place = {place[0], place[1], place[2]};
        e.velocity = {velocity[0], velocity[1], velocity[2]};
        e.size = numbers[6 * n + i];
        e.volume = e.size * e.size * e.size;
        if (!e.place.allFinite() || !e.velocity.allFinite() || !(e.size > 0) || !std::isfinite(e.size))
            throw InputError(fmt::format("{}: particle {} has no place, velocity or spacing; expected finite numbers",
                                         from.file.string(), i));
    }
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
