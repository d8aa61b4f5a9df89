#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {

/// A stepped flying-boat hull with the length of the seaplane in Xu et al. 2023 (doi:10.1016/j.taml.2023.100463), 36.9
/// m. That aircraft's lines are not public: this is a stand-in of usual flying-boat proportions (NACA hull practice:
/// deadrise about 20 degrees and flared chines on the forebody, a transverse step of 5 to 10 % of the beam at
/// mid-length, an afterbody rising 6 to 9 degrees to the sternpost, a slender tail above). Forces on it are not those
/// of the original.
class SeaplaneLines {
public:
    explicit SeaplaneLines(const std::map<std::string, double>& v)
        : length_(v.at("length")),
          half_beam_(v.at("beam") / 2),
          deadrise_(v.at("deadrise")),
          flare_(v.at("flare")),
          step_(v.at("step_position") * v.at("length")),
          step_height_(v.at("step_height")),
          height_(v.at("height")),
          afterbody_rise_(std::tan(v.at("sternpost_angle"))) {}

    Surface make() const {
        constexpr int fore = 36, aft = 40;
        std::vector<HalfSection> sections;
        for (int i = 0; i <= fore; ++i) {  // close stations at the round nose
            const double u = static_cast<double>(i) / fore;
            sections.push_back(forebody(step_ * (i == fore ? 1 : 1 - std::cos(0.5 * std::numbers::pi * u))));
        }
        for (int i = 0; i <= aft; ++i) sections.push_back(afterbody(step_ + (length_ - step_) * i / aft));
        return loft(sections);
    }

private:
    static constexpr int bottom_parts = 8, side_parts = 5, crown_parts = 8;

    /// 0 at the nose, 1 from `end` on, round in between with a vertical tangent at the nose (a superellipse).
    static double rounded(double s, double end, double power) {
        const double u = std::clamp(1 - s / end, 0.0, 1.0);
        return std::sqrt(std::max(0.0, 1 - std::pow(u, power)));
    }
    double nose_height() const { return 0.55 * height_; }

    /// Bottom from the keel to the chine, upright-ish sides to the shoulder, elliptic crown. `flare` bends the outer
    /// part of the bottom down towards the horizontal, which throws the spray sideways.
    HalfSection section(double s, double keel, double half_beam, double deadrise, double flare,
                        double shoulder_half_width, double top, double chine_to_shoulder_from) const {
        const double x = s - length_ / 2;
        HalfSection points;
        const auto bottom = [&](double eta) {  // the slope falls over the outer 40 % of the half-beam
            const double outer = std::max(0.0, eta - 0.6);
            return keel + half_beam * (std::tan(deadrise) * eta - flare * outer * outer / 0.8);
        };
        for (int k = 0; k <= bottom_parts; ++k) {
            const double eta = static_cast<double>(k) / bottom_parts;
            points.emplace_back(x, half_beam * eta, bottom(eta));
        }
        const double chine = points.back().z();
        // The first side point is where the afterbody's chine begins behind the step: both sections then share their
        // sides.
        const double first = chine + chine_to_shoulder_from;
        points.emplace_back(x, half_beam, first);
        const double shoulder = first + 0.5 * (top - first);
        for (int k = 1; k <= side_parts; ++k) {
            const double u = static_cast<double>(k) / side_parts;
            points.emplace_back(x, half_beam + (shoulder_half_width - half_beam) * u * u,
                                first + (shoulder - first) * u);
        }
        for (int k = 1; k <= crown_parts; ++k) {
            const double angle = 0.5 * std::numbers::pi * k / crown_parts;
            points.emplace_back(x, k == crown_parts ? 0 : shoulder_half_width * std::cos(angle),
                                shoulder + (top - shoulder) * (k == crown_parts ? 1 : std::sin(angle)));
        }
        return points;
    }

    HalfSection forebody(double s) const {
        const double bow = 0.55 * step_;  // from here aft the keel is straight
        const double u = std::clamp(1 - s / bow, 0.0, 1.0);
        const double keel = nose_height() * std::pow(u, 2.4);
        const double half_beam = half_beam_ * rounded(s, 0.7 * step_, 2.2);
        const double deadrise = deadrise_ + (50 * degree - deadrise_) * u * u;
        const double shoulder = 1.04 * half_beam_ * rounded(s, 0.7 * step_, 2.2);
        const double top = height_ - (height_ - nose_height()) * (1 - rounded(s, 0.45 * step_, 2));
        // The sides begin a step's height above the chine, less at the nose, where the section shrinks to a point.
        return section(s, keel, half_beam, deadrise, flare_ * std::tan(deadrise_), shoulder, top,
                       step_height_ * rounded(s, 0.7 * step_, 2.2));
    }

    /// Keel line: the step's height above the forebody, rising to the sternpost at 0.78 of the length and steeper
    /// behind it. Its flare fades at once behind the step and the chines draw together towards the tail.
    HalfSection afterbody(double s) const {
        const double u = (s - step_) / (length_ - step_);
        const double sternpost = 0.78 * length_;
        const double steeper = std::max(0.0, s - sternpost);
        const double rise = afterbody_rise_ * (s - step_);
        const double tail_keel = 0.72 * height_;  // height of the keel line at the very end, reached smoothly
        const double straight_end = step_height_ + afterbody_rise_ * (length_ - step_);
        const double extra = std::max(0.0, tail_keel - straight_end);
        const double tail = length_ - sternpost;
        const double keel = step_height_ + rise + extra * steeper * steeper / (tail * tail);
        const double half_beam = half_beam_ * (1 - 0.82 * u * u);
        const double shoulder = 1.04 * half_beam_ * (1 - 0.8 * u * u);
        const double top = height_ * (1 + 0.04 * u);
        const double flare = flare_ * std::tan(deadrise_) * std::max(0.0, 1 - 4 * u);
        return section(s, keel, half_beam, deadrise_, flare, shoulder, top, 0);
    }

    double length_, half_beam_, deadrise_, flare_, step_, step_height_, height_, afterbody_rise_;
};

Surface make_seaplane(const std::map<std::string, double>& v) { return SeaplaneLines(v).make(); }
}  // namespace

HullShape seaplane_shape() {
    return {
        "seaplane",
        "stepped flying-boat hull, 36.9 m long; a stand-in for a published seaplane study, whose lines are not public",
        {{"length", "m", "over all", 36.9, 1, 200},
         {"beam", "m", "over the forebody chines", 3.4, 0.1, 20},
         {"deadrise", "rad", "of the straight forebody and of the afterbody", 22 * degree, 5 * degree, 40 * degree},
         {"flare", "-", "fall of the forebody's slope at the chine, 1: horizontal there", 0.8, 0, 1.2},
         {"step_position", "-", "of the step from the bow, in lengths", 0.5, 0.35, 0.65},
         {"step_height", "m", "depth of the step at the keel", 0.27, 0.01, 2},
         {"sternpost_angle", "rad", "rise of the afterbody keel", 7 * degree, 2 * degree, 12 * degree},
         {"height", "m", "from the forebody keel to the crown of the hull", 4.4, 0.5, 20}},
        make_seaplane};
}

}  // namespace tw
