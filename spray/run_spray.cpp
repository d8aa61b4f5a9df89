#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>

#include "base/errors.h"
#include "record/run_record.h"
#include "record/spray_table.h"
#include "spray/study.h"

namespace tw::spray {
namespace fs = std::filesystem;
namespace {

bool is_half(const RunRecord& record) {
    const auto factor = record.attributes.find("symmetry_factor");
    return factor != record.attributes.end() && factor->second == "2";
}
/// True where a run's record says that half of the hull was solved.
bool is_half(const fs::path& run) {
    const fs::path file = run / "record.h5";
    return fs::exists(file) && is_half(read_record(file));
}

/// What the gate of a run took out of it, see spray_table.
void extract_taken(const SprayStudy& study, SprayResult& result) {
    const fs::path file = study.source.taken / "record.h5";
    if (!fs::exists(file)) throw InputError(file.string() + ": not there; expected RUN/sph of a run with a spray gate");
    RunRecord record = read_record(file);
    if (!record.numbers.contains(spray_gate_number))
        throw InputError(
            file.string() +
            ": the run had no spray gate; expected gate_point and gate_normal in [sph] of its scene, or sph = "
            "... to look through its snapshots");
    if (record.tables.contains(spray_table)) {
        Table& t = record.table(spray_table);
        const auto column = [&t](const char* name, const char* unit) -> const std::vector<double>& {
            std::vector<double>& values = t.column(name, unit).values;
            values.resize(t.time.size());
            return values;
        };
        const auto &x = column("x", "m"), &y = column("y", "m"), &z = column("z", "m"), &u = column("vx", "m/s"),
                   &v = column("vy", "m/s"), &w = column("vz", "m/s"), &mass = column("mass", "kg"),
                   &inner = column("inner_energy", "J"), &particles = column("particles", "-");
        const bool mirror = study.source.mirror.value_or(is_half(record));
        Extractor extractor(study.extraction, *study.air);
        for (std::size_t i = 0; i < t.time.size(); ++i) {
            const FrameRange& range = study.source.range;
            if (t.time[i] < range.from || t.time[i] > range.to) continue;
            const double volume = mass[i] / study.extraction.liquid.density;
            TakenLump lump{{{x[i], y[i], z[i]}, {u[i], v[i], w[i]}, volume, std::cbrt(volume)},
                           static_cast<std::size_t>(particles[i]),
                           inner[i]};
            extractor.take_lump(t.time[i], lump);
            lump.water.place.y() = -lump.water.place.y(), lump.water.velocity.y() = -lump.water.velocity.y();
            if (mirror) extractor.take_lump(t.time[i], lump);
        }
        result.extraction = extractor.result();
    }
    result.droplets = result.extraction.droplets;
}

void extract(const SprayStudy& study, SprayResult& result) {
    const Source& from = study.source;
    const int ways = !from.sph.empty() + !from.taken.empty() + !from.fvm.empty() + !from.droplets.empty();
    if (ways != 1) throw InputError("source: expected exactly one of sph, taken, fvm and table, with droplets in it");
    if (!from.taken.empty()) return extract_taken(study, result);
    if (!from.droplets.empty()) {
        result.droplets = from.droplets;
        return;
    }
    const fs::path& run = from.sph.empty() ? from.fvm : from.sph;
    const auto frames = from.sph.empty() ? foam_frames(run, from.range) : particle_frames(run, from.range);
    const bool mirror = from.mirror.value_or(is_half(run));
    if (study.extraction.gate.is_open() && frames.size() > 1)
        throw InputError(
            fmt::format("{}: {} frames between from and to, and no gate: the same water would be taken again. "
                        "Give a gate, or from and to round one of them, e.g. at {:g} s",
                        run.string(), frames.size(), frames.back().time));
    Extractor extractor(study.extraction, *study.air);
    for (const FrameFile& file : frames) {
        WaterFrame frame =
            from.sph.empty() ? read_cells(file, from.least_share, result.left_out) : read_particles(file);
        extractor.look_at(mirror ? mirrored(std::move(frame)) : frame);
    }
    result.extraction = extractor.result();
    result.droplets = result.extraction.droplets;
}

/// Slices of the room, filled by threads at once.
class Envelope {
public:
    Envelope(const Box& room, int axis) : axis_(axis), low_(room.min[axis]) {
        width_ = std::max(room.size()[axis], 1e-9) / slices;
        highest_.assign(slices, -1e30), moment_.assign(slices, 0), volume_.assign(slices, 0);
    }
    void add(const Vec3& place, double volume) {
        const auto k = static_cast<std::size_t>(std::clamp((place[axis_] - low_) / width_, 0.0, slices - 1.0));
        highest_[k] = std::max(highest_[k], place.z());
        moment_[k] += volume * place.z(), volume_[k] += volume;
    }
    std::vector<EnvelopeSlice> filled() const {
        std::vector<EnvelopeSlice> all;
        for (std::size_t k = 0; k < slices; ++k)
            if (volume_[k] > 0)
                all.push_back({low_ + (static_cast<double>(k) + 0.5) * width_, highest_[k], moment_[k] / volume_[k]});
        return all;
    }

private:
    static constexpr int slices = 60;
    int axis_;
    double low_, width_;
    std::vector<double> highest_, moment_, volume_;
};

void fly_all(const SprayStudy& study, SprayResult& result) {
    FlightOptions options = flight_of(study);
    double first = 1e300, last = -1e300;
    for (const Droplet& d : result.droplets) first = std::min(first, d.time), last = std::max(last, d.time);
    options.end_time = last + study.duration;
    options.sample = result.droplets.empty() ? 0 : (options.end_time - first) / 200;

    std::vector<FirstHit> surfaces;
    for (const TargetSurface& t : study.targets)
        surfaces.emplace_back(t.surface), result.target_names.push_back(t.name);
    if (study.sensor) surfaces.emplace_back(study.sensor->sensor.surface()), result.target_names.emplace_back("sensor");
    std::vector<Target> targets;
    for (std::size_t t = 0; t < surfaces.size(); ++t) targets.push_back({result.target_names[t], &surfaces[t]});

    result.landings = fly(result.droplets, *study.air, targets, options);
    const auto outside = [](const Landing& l) { return l.fate == Fate::left_air; };
    if (study.refuse_left_air)
        if (const auto out = std::ranges::find_if(result.landings, outside); out != result.landings.end())
            throw InputError(
                fmt::format("air: {} of {} droplets leave the field, the first at ({:.3g}, {:.3g}, {:.3g}) m and "
                            "{:.4g} s; expected a "
                            "field that covers the flight. Widen it, fly for a shorter time, or set outside = \"end\"",
                            std::ranges::count_if(result.landings, outside), result.landings.size(), out->place.x(),
                            out->place.y(), out->place.z(), out->time));

    const Vec3& gravity = options.forces.gravity;
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const Box box = surfaces[t].bounds();
        result.reaches.push_back(reach(result.droplets, 0.5 * (box.min + box.max), gravity));
    }
    for (std::size_t i = 0; i < result.droplets.size(); ++i) {
        const Landing& l = result.landings[i];
        Budget& end = l.fate == Fate::hit ? result.landed : l.fate == Fate::fell_back ? result.back : result.away;
        end.add(sphere_volume(result.droplets[i].diameter), l.place, l.velocity, options.water_density, gravity);
    }

    // The envelope is filled on a second way over the same paths, when the room that they take is known.
    Box room{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (std::size_t i = 0; i < result.droplets.size(); ++i) {
        room.min = room.min.cwiseMin(result.droplets[i].place).cwiseMin(result.landings[i].place);
        room.max = room.max.cwiseMax(result.droplets[i].place).cwiseMax(result.landings[i].place);
    }
    if (result.droplets.empty()) return;
    Envelope side(room, 0), front(room, 1);
    std::mutex one_at_a_time;
    // every hundredth droplet of a large spray draws the same picture
    const std::size_t stride = 1 + result.droplets.size() / 20000;
    std::vector<Droplet> some;
    for (std::size_t i = 0; i < result.droplets.size(); i += stride) some.push_back(result.droplets[i]);
    fly(some, *study.air, targets, options, [&](std::size_t i, double, const Vec3& place, const Vec3&) {
        const std::lock_guard lock(one_at_a_time);
        side.add(place, sphere_volume(some[i].diameter));
        front.add(place, sphere_volume(some[i].diameter));
    });
    result.side = side.filled();
    result.front = front.filled();
}

/// The window of the study's edge and length that has the largest average, of all that lie side by side on the sensor
/// and in time.
Window fullest(std::span<const Arrival> arrivals, const SensorStudy& s, double begin) {
    const double edge = s.window.edge;
    const auto side = std::lround(std::sqrt(static_cast<double>(tiled(s.sensor, s.window).size())) - 1) / 2;
    std::map<std::array<long, 3>, double> impulses;
    for (const Arrival& a : arrivals) {
        const long i = std::lround(a.across / edge), j = std::lround(a.along / edge);
        if (std::abs(i) > side || std::abs(j) > side) continue;
        if (!s.load.keep_outside && !within_law(a.normal_speed, a.diameter, s.load.liquid)) continue;
        const auto k = static_cast<long>(std::floor((a.time - begin) / s.window.length));
        impulses[{i, j, k}] += impulse(a.normal_speed, a.diameter, s.load.liquid);
    }
    Window w = s.window;
    w.from = begin;
    if (impulses.empty()) return w;
    const auto best = std::ranges::max_element(impulses, {}, [](const auto& one) { return one.second; })->first;
    w.across = static_cast<double>(best[0]) * edge, w.along = static_cast<double>(best[1]) * edge;
    w.from = begin + static_cast<double>(best[2]) * s.window.length;
    return w;
}

WindowLoad load_of(std::span<const Arrival> arrivals, const Window& window, const SensorStudy& s) {
    return {window, estimate(arrivals, window, s.load), bootstrap(arrivals, {&window, 1}, s.load, s.draws)};
}

void load_sensor(const SprayStudy& study, SprayResult& result) {
    SensorStudy s = *study.sensor;
    s.load.liquid = study.extraction.liquid;
    if (!(s.sensor.extent > 0) || !(s.sensor.normal.norm() > 0))
        throw InputError("sensor: extent and normal are above 0");
    if (s.window.edge > s.sensor.extent)
        throw InputError(fmt::format("sensor: a window of {:g} m does not fit on an extent of {:g} m", s.window.edge,
                                     s.sensor.extent));
    if (!(s.face > 0)) throw InputError("sensor: face is above 0");
    if (!s.measured.empty()) result.measured = repeats_of(s.measured);
    const auto sensor = static_cast<int>(result.target_names.size()) - 1;
    result.arrivals = arrivals(s.sensor, sensor, result.droplets, result.landings);
    if (result.arrivals.empty()) return;

    const double first = result.arrivals.front().time, last = result.arrivals.back().time;
    const double begin = std::floor(first / s.window.length) * s.window.length;
    const auto count = static_cast<std::size_t>(std::floor((last - begin) / s.window.length)) + 1;
    if (count > 100000)
        throw InputError(
            fmt::format("sensor: arrivals over {:g} s need {} windows of {:g} s; expected a longer time_window",
                        last - first, count, s.window.length));
    for (std::size_t k = 0; k < count; ++k) {
        Window w = s.window;
        w.from = begin + static_cast<double>(k) * w.length;
        result.windows.push_back(load_of(result.arrivals, w, s));
    }
    result.peak = *std::ranges::max_element(result.windows, {}, [](const WindowLoad& w) { return w.estimate.average; });
    result.anywhere = load_of(result.arrivals, fullest(result.arrivals, s, begin), s);
    result.face = face_hits(result.arrivals, s.sensor.extent, s.face, s.load.liquid);
    const Window& best = result.peak->window;
    const auto tiles = tiled(s.sensor, best);
    result.tiles = tiles.size();
    result.over_windows = bootstrap(result.arrivals, tiles, s.load, s.draws);
    const double middle = best.from + 0.5 * best.length;
    for (const double edge : s.edges) {
        Window w = best;
        w.edge = edge;
        if (edge <= s.sensor.extent) result.by_area.push_back(load_of(result.arrivals, w, s));
    }
    for (const double length : s.lengths) {
        Window w = best;
        w.length = length, w.from = middle - 0.5 * length;
        result.by_length.push_back(load_of(result.arrivals, w, s));
    }
    Window whole = s.window;
    whole.from = first - 5 * s.load.sampling, whole.length = last - first + 10 * s.load.sampling + 3e-3;
    result.curve = direct_load(result.arrivals, whole, s.load);
}

}  // namespace

FlightOptions flight_of(const SprayStudy& study) {
    FlightOptions options = study.flight;
    options.water_density = study.extraction.liquid.density;
    options.forces.gravity = study.extraction.gravity;
    return options;
}

SprayResult run_spray(const SprayStudy& study) {
    SprayResult result;
    extract(study, result);
    fly_all(study, result);
    if (study.sensor) load_sensor(study, result);
    return result;
}

}  // namespace tw::spray
