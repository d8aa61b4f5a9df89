#include "spray/extract/extract.h"

#include <fmt/format.h>

#include <numeric>

#include "base/errors.h"

namespace tw::spray {

namespace {

/// Numbers of components of which each is one element.
std::vector<int> each_alone(std::size_t count) {
    std::vector<int> number(count);
    std::iota(number.begin(), number.end(), 0);
    return number;
}

}  // namespace

struct Extractor::Component {
    std::vector<std::size_t> elements;
    std::size_t pieces = 0;  ///< particles or cells
    double volume = 0;
    Vec3 centre = Vec3::Zero(), velocity = Vec3::Zero();  ///< means by volume
};

Extractor::Extractor(const ExtractOptions& options, const Air& air)
    : options_(options), air_(air), random_(options.seed) {
    if (options.fewest < 1) throw InputError("fewest: at least 1 particle or cell makes a droplet");
    if (!(options.largest_diameter > 0)) throw InputError("largest_diameter: above 0");
    if (!(options.liquid.density > 0) || !(options.liquid.surface_tension > 0) || !(options.liquid.viscosity > 0))
        throw InputError("liquid: density, viscosity and surface tension are above 0");
    check_breakup(options.breakup);
}

bool Extractor::beyond_before(const Component& c, double interval) const {
    const Vec3 before = c.centre - interval * c.velocity + 0.5 * interval * interval * options_.gravity;
    return options_.gate.beyond(before);
}

void Extractor::add_droplet(const Vec3& place, const Vec3& velocity, double volume, double time) {
    if (result_.droplets.size() >= options_.most)
        throw InputError(
            fmt::format("more than {} droplets; expected fewer: raise the smallest fragment, take fewer "
                        "frames, or set the gate farther out",
                        options_.most));
    result_.droplets.push_back({place, velocity, sphere_diameter(volume), time});
    result_.ledger.droplets.add(volume, place, velocity, options_.liquid.density, options_.gravity);
}

void Extractor::take(const Component& c, const WaterFrame& frame) {
    const auto& elements = frame.elements;
    const double density = options_.liquid.density;
    if (options_.size == DropletSize::element) {
        for (const std::size_t i : c.elements)
            add_droplet(elements[i].place, elements[i].velocity, elements[i].volume, frame.time);
        return;
    }
    for (const std::size_t i : c.elements)
        result_.ledger.inner_energy +=
            0.5 * density * elements[i].volume * (elements[i].velocity - c.velocity).squaredNorm();
    AirState air;
    std::vector<double> diameters{sphere_diameter(c.volume)};
    if (options_.size == DropletSize::breakup && air_.at(c.centre, air)) {
        const double slip = (c.velocity - air.velocity).norm();
        const double d_max = largest_stable_diameter(slip, air, options_.liquid, options_.breakup.critical_weber);
        if (c.volume > static_cast<double>(options_.most) * sphere_volume(d_max))
            throw InputError(fmt::format("a lump of {:.3g} m3 at {:.3g} m/s would break into more than {} droplets",
                                         c.volume, slip, options_.most));
        diameters = fragments(c.volume, d_max, options_.breakup, random_);
    }
    if (diameters.size() == 1) return add_droplet(c.centre, c.velocity, c.volume, frame.time);

    // Fragments stand where the component's elements are, and their centre of mass where its was.
    std::uniform_int_distribution<std::size_t> any(0, c.elements.size() - 1);
    std::uniform_real_distribution<double> around(-0.5, 0.5);
    std::vector<Vec3> places;
    Vec3 centre = Vec3::Zero();
    for (const double d : diameters) {
        const Element& e = elements[c.elements[any(random_)]];
        const double x = around(random_), y = around(random_), z = around(random_);
        places.push_back(e.place + e.size * Vec3(x, y, z));
        centre += sphere_volume(d) / c.volume * places.back();
    }
    for (std::size_t i = 0; i < diameters.size(); ++i)
        add_droplet(places[i] + c.centre - centre, c.velocity, sphere_volume(diameters[i]), frame.time);
}

/// Sorts out what is detached and newly beyond the gate.
void Extractor::settle(const Component& c, const Budget& sum, const WaterFrame& frame, FrameCount& count) {
    if (sphere_diameter(c.volume) > options_.largest_diameter) {
        result_.ledger.lumps += sum;
    } else if (c.pieces < options_.fewest) {
        result_.ledger.crumbs += sum;
    } else {
        result_.ledger.taken += sum;
        count.taken += c.volume;
        const std::size_t before = result_.droplets.size();
        take(c, frame);
        count.droplets += result_.droplets.size() - before;
    }
}

void Extractor::take_lump(double time, const TakenLump& lump) {
    const Element& e = lump.water;
    const WaterFrame frame{time, {e}};
    if (result_.frames.empty() || result_.frames.back().time < time) result_.frames.push_back({.time = time});
    FrameCount& count = result_.frames.back();
    Budget sum;
    sum.add(e.volume, e.place, e.velocity, options_.liquid.density, options_.gravity);
    sum.kinetic_energy += lump.inner_energy;
    sum.pieces = lump.pieces;
    result_.ledger.all += sum;
    ++count.components;
    count.detached += e.volume, count.beyond += e.volume;
    const std::size_t before = result_.droplets.size();
    settle({{0}, lump.pieces, e.volume, e.place, e.velocity}, sum, frame, count);
    if (result_.droplets.size() > before) result_.ledger.inner_energy += lump.inner_energy;
    result_.ledger.shifted_energy = result_.ledger.droplets.potential_energy - result_.ledger.taken.potential_energy;
}

void Extractor::look_at(const WaterFrame& frame) {
    const bool open = options_.gate.is_open();
    if (begun_ && open)
        throw InputError("several frames without a gate would take the same water again; give a gate, or one time");
    if (begun_ && !(frame.time > last_time_))
        throw InputError(
            fmt::format("a frame at {:g} s after one at {:g} s; expected rising times", frame.time, last_time_));
    const double interval = frame.time - last_time_;

    const auto number =
        options_.attached ? each_alone(frame.elements.size()) : components(frame.elements, options_.link);
    std::vector<Component> all;
    for (std::size_t i = 0; i < frame.elements.size(); ++i) {
        const auto k = static_cast<std::size_t>(number[i]);
        if (all.size() <= k) all.resize(k + 1);
        const Element& e = frame.elements[i];
        all[k].elements.push_back(i);
        all[k].volume += e.volume;
        ++all[k].pieces;
        all[k].centre += e.volume * e.place;
        all[k].velocity += e.volume * e.velocity;
    }

    Ledger& ledger = result_.ledger;
    FrameCount count;
    count.time = frame.time;
    for (std::size_t k = 0; k < all.size(); ++k) {
        Component& c = all[k];
        Budget sum;
        for (const std::size_t i : c.elements) {
            const Element& e = frame.elements[i];
            sum.add(e.volume, e.place, e.velocity, options_.liquid.density, options_.gravity);
        }
        ledger.all += sum;
        if ((k == 0 && !options_.attached) || !(c.volume > 0)) {
            ledger.body += sum;
            continue;
        }
        c.centre /= c.volume, c.velocity /= c.volume;
        ++count.components;
        count.detached += c.volume;
        const bool beyond = options_.gate.beyond(c.centre);
        const bool was_beyond = !open && (begun_ ? beyond_before(c, interval) : !options_.already_beyond);
        if (!beyond && begun_ && was_beyond) ledger.returned += c.volume;
        if (beyond) count.beyond += c.volume;
        if (!beyond) {
            ledger.before_gate += sum;
        } else if (was_beyond) {
            ledger.earlier += sum;
        } else {
            settle(c, sum, frame, count);
        }
    }
    result_.frames.push_back(count);
    ledger.shifted_energy = ledger.droplets.potential_energy - ledger.taken.potential_energy;
    begun_ = true;
    last_time_ = frame.time;
}

}  // namespace tw::spray
