#include "spray/flight/fly.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "spray/flight/dormand_prince.h"

namespace tw::spray {
namespace {

/// One droplet on its way.
class Path {
public:
    Path(const Droplet& droplet, const Air& air, std::span<const Target> targets, const FlightOptions& options)
        : droplet_(droplet), air_(air), targets_(targets), o_(options) {}

    Landing fly(std::size_t number, const Visitor& visitor) {
        time_ = droplet_.time;
        step_.y0 << droplet_.place, droplet_.velocity;
        above_ = reynolds(step_.y0) > Re_of_the_jump;
        step_.k[0] = rate(step_.y0);
        if (!covered_) return ended(Fate::left_air, 0);
        if (o_.falls_back && droplet_.place.z() < o_.water_level) return ended(Fate::fell_back, 0);
        double h = first_step();
        bool to_jump = false;  // this step ends where the drag jumps
        double next_sample = o_.sample > 0 ? std::ceil(time_ / o_.sample) * o_.sample : 0;
        while (time_ < o_.end_time) {
            h = std::min(h, o_.end_time - time_);
            covered_ = true;
            step_.take(h, [this](const State6& y) { return rate(y); });
            const double wrong = covered_ ? error_norm() : 0;
            if (wrong > 1 || (!covered_ && h > shortest)) {
                to_jump = false;
                h *= covered_ ? std::max(0.2, 0.9 * std::pow(wrong, -0.2)) : 0.25;
                continue;
            }
            if (!covered_) return ended(Fate::left_air, 0);
            // The drag jumps at Re = 1000: the step that crosses it is taken again up to there, and the next one begins
            // on the other side. Never twice in a row: a droplet may fall for ever at the Re of the jump.
            const bool crossed = (reynolds(step_.y1) > Re_of_the_jump) != above_;
            if (crossed && !to_jump) {
                h *= root(0, 1, [this](double s) { return reynolds(step_.at(s)) - Re_of_the_jump; });
                to_jump = true;
                continue;
            }
            const bool other_side = to_jump || crossed;
            to_jump = false;
            const Landing landing = stopped_in_step();
            const double until = landing.fate == Fate::flying ? time_ + h : landing.time;
            for (; visitor && o_.sample > 0 && next_sample <= until; next_sample += o_.sample) {
                const State6 y = step_.at(h > 0 ? (next_sample - time_) / h : 0);
                visitor(number, next_sample, y.head<3>(), y.tail<3>());
            }
            if (landing.fate != Fate::flying) return landing;
            time_ += h;
            step_.y0 = step_.y1;
            step_.k[0] = step_.k[6];  // first same as last
            if (other_side) {
                above_ = !above_;
                step_.k[0] = rate(step_.y0);
            }
            h *= std::min(5.0, 0.9 * std::pow(std::max(wrong, 1e-10), -0.2));
        }
        return ended(Fate::flying, 0);
    }

private:
    static constexpr double shortest = 1e-9;  ///< [s] to which the way out of the air field is followed

    State6 rate(const State6& y) {
        State6 r;
        if (!air_.at(y.head<3>(), here_)) covered_ = false;  // the last known air; the step is taken again, shorter
        r << y.tail<3>(), acceleration(y.tail<3>(), droplet_.diameter, here_, o_.water_density, o_.forces, above_);
        return r;
    }
    double reynolds(const State6& y) const {
        AirState air;
        return air_.at(y.head<3>(), air) ? sphere_reynolds((y.tail<3>() - air.velocity).norm(), droplet_.diameter, air)
                                         : 0;
    }
    /// A hundredth of the time in which the velocity changes by itself.
    double first_step() const {
        const double v = step_.y0.tail<3>().norm(), a = step_.k[0].tail<3>().norm();
        return std::max(1e-7, 0.01 * (v + 1e-3) / (a + 1e-9));
    }
    /// Above 1: the step is too long. Places are judged by the way flown in the time the velocity needs to change.
    double error_norm() const {
        const double speed = std::max({step_.y0.tail<3>().norm(), step_.y1.tail<3>().norm(), 1e-3});
        const double change = speed / (step_.k[6].tail<3>().norm() + 1e-9);
        const double way = speed * std::min(change, 1.0);
        return std::max(step_.error.head<3>().norm() / way, step_.error.tail<3>().norm() / speed) / o_.tolerance;
    }
    Landing ended(Fate fate, double share) const {
        const State6 y = share > 0 ? step_.at(share) : step_.y0;
        Landing l;
        l.fate = fate, l.time = time_ + share * (share > 0 ? step_.h : 0);
        l.place = y.head<3>(), l.velocity = y.tail<3>();
        return l;
    }

    /// Box round the step's path: its ends and as much as it can bend between them.
    Box reach() const {
        double bend = 0;
        for (const State6& k : step_.k) bend = std::max(bend, k.tail<3>().norm());
        bend *= step_.h * step_.h / 2;
        const Vec3 a = step_.y0.head<3>(), b = step_.y1.head<3>();
        return {a.cwiseMin(b).array() - bend, a.cwiseMax(b).array() + bend};
    }
    static bool overlap(const Box& a, const Box& b) {
        return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
    }
    /// The share at which f, of opposite signs at the ends, vanishes along the step.
    template <class F>
    static double root(double low, double high, F f) {
        const bool rising = f(low) < f(high);
        for (int i = 0; i < 50 && high - low > 1e-13; ++i) {
            const double middle = 0.5 * (low + high);
            ((f(middle) < 0) == rising ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    Landing stopped_in_step() const {
        double share = 2;
        Landing landing;
        const Box path = reach();
        for (std::size_t t = 0; t < targets_.size(); ++t)
            if (overlap(path, targets_[t].surface->bounds())) seek_hit(t, share, landing);
        if (o_.falls_back && path.min.z() < o_.water_level) seek_water(share, landing);
        return landing;
    }
    void seek_hit(std::size_t target, double& share, Landing& landing) const {
        const FirstHit& surface = *targets_[target].surface;
        const double slack = 1e-5 * surface.bounds().size().norm();
        const double bend = (reach().size() - (step_.y1 - step_.y0).head<3>().cwiseAbs()).norm() / 8;
        const int chords = std::clamp(static_cast<int>(std::ceil(std::sqrt(bend / slack))), 1, 2000);
        Vec3 from = step_.y0.head<3>();
        for (int i = 0; i < chords; ++i) {
            const double s0 = static_cast<double>(i) / chords, s1 = static_cast<double>(i + 1) / chords;
            if (s0 >= share) return;
            const Vec3 to = step_.at(s1).head<3>();
            const auto hit = surface.on(from, to);
            if (hit) {
                const auto height = [&](double s) { return (step_.at(s).head<3>() - hit->point).dot(hit->normal); };
                double s = s0 + hit->share * (s1 - s0);
                if (height(s0) * height(s1) < 0) s = root(s0, s1, height);
                if (s >= share) return;
                share = s;
                landing = ended(Fate::hit, std::max(s, 1e-300));
                landing.target = static_cast<int>(target), landing.triangle = hit->triangle;
                landing.normal_speed = std::abs(landing.velocity.dot(hit->normal));
                landing.angle = std::asin(std::min(1.0, landing.normal_speed / landing.velocity.norm()));
                return;
            }
            from = to;
        }
    }
    /// The way down through the water's surface, judged by the ends of the step: only an updraught could dip a droplet
    /// and lift it again within one.
    void seek_water(double& share, Landing& landing) const {
        if (step_.y1.z() >= o_.water_level) return;
        const double s = root(0, 1, [&](double at) { return step_.at(at).z() - o_.water_level; });
        if (s < share) share = s, landing = ended(Fate::fell_back, std::max(s, 1e-300));
    }

    const Droplet& droplet_;
    const Air& air_;
    std::span<const Target> targets_;
    const FlightOptions& o_;
    DormandPrinceStep step_;
    AirState here_;
    bool covered_ = true;  ///< the last step kept to the air field
    bool above_ = false;   ///< the law of drag above its jump holds
    double time_ = 0;
};

void check(std::span<const Droplet> droplets) {
    for (std::size_t i = 0; i < droplets.size(); ++i) {
        const Droplet& d = droplets[i];
        if (!(d.diameter > 0) || !std::isfinite(d.diameter))
            throw InputError(fmt::format("droplet {}: a diameter of {:g} m; expected above 0", i + 1, d.diameter));
        if (!d.place.allFinite() || !d.velocity.allFinite() || !std::isfinite(d.time))
            throw InputError(fmt::format("droplet {}: place, velocity or time is not finite", i + 1));
    }
}

}  // namespace

const char* to_string(Fate fate) {
    switch (fate) {
        case Fate::flying: return "flying";
        case Fate::hit: return "hit";
        case Fate::fell_back: return "fell_back";
        case Fate::left_air: return "left_air";
    }
    return "";
}

std::vector<Landing> fly(std::span<const Droplet> droplets, const Air& air, std::span<const Target> targets,
                         const FlightOptions& options, const Visitor& visitor) {
    check(droplets);
    if (!(options.tolerance > 0) || !(options.water_density > 0))
        throw InputError("flight: tolerance and water density are above 0");
    std::vector<Landing> landings(droplets.size());
    const auto n = static_cast<std::ptrdiff_t>(droplets.size());
#pragma omp parallel for schedule(dynamic, 256) if (n > 256)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        landings[at] = Path(droplets[at], air, targets, options).fly(at, visitor);
    }
    return landings;
}

}  // namespace tw::spray
