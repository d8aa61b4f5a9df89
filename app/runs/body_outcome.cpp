#include "app/runs/body_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "text/plain_degrees.h"
#include "text/plain_number.h"

namespace tw::app {

namespace {

/// As people write it; rounding about 0 is 0.
std::string number_in_words(double value) { return plain_number(std::abs(value) < 1e-9 ? 0 : value, 4); }

/// The largest of each gauge and of the frame's acceleration, and what the interface made of the energy.
std::string outcome_of_elastic(const MovingBody& body, const Table& t, const Scene& scene) {
    const auto most = [&](const std::string& column, const char* unit) {
        const Column* c = t.find(column);
        if (!c) return std::string();
        std::size_t at = c->values.size();  // where a method knows nothing stands NaN
        for (std::size_t k = 0; k < c->values.size(); ++k)
            if (std::isfinite(c->values[k]) && !(at < k && std::abs(c->values[k]) <= std::abs(c->values[at]))) at = k;
        if (at == c->values.size()) return std::string();
        return fmt::format("  {} at most {}{} at {} s\n", column, number_in_words(c->values[at]), unit,
                           number_in_words(t.time[at]));
    };
    std::string out = fmt::format("elastic body {} at {} s:\n", body.name, number_in_words(t.time.back())) +
                      most("az", " m/s2") + most("fx", scene.spanwise_unit(" N").c_str()) +
                      most("fz", scene.spanwise_unit(" N").c_str());
    out += most("floor_force", " N");
    for (const ElasticGauge& g : std::visit([](const auto& part) { return part.gauges; }, *body.elastic))
        if (g.direction)
            out += most(g.name, "");
        else
            for (const char* axis : {"_x", "_y", "_z"}) out += most(g.name + axis, " m");
    if (!t.find("work_taken")) return out;  // rigid in this method's run
    const auto last = [&](const char* column) { return t.find(column)->values.back(); };
    out += fmt::format(
        "  work of the water on it {} {}, {} exchanged in both directions; the interface generated {:+.2g} % "
        "of the latter\n",
        number_in_words(last("work_taken")), scene.spanwise_unit("J"), number_in_words(last("work_exchanged")),
        100 * (last("work_taken") - last("work_given")) / std::max(1e-300, last("work_exchanged")));
    return out;
}

}  // namespace

std::string outcome_of_bodies(const Scene& scene, const RunRecord& record) {
    std::string out;
    for (const MovingBody& body : scene.bodies) {
        const auto found = record.tables.find(body_table(body.name));
        if (found == record.tables.end() || found->second.time.empty()) continue;
        const Table& t = found->second;
        if (body.elastic) {
            out += outcome_of_elastic(body, t, scene);
            if (const auto how = record.attributes.find("one_way"); how != record.attributes.end())
                out += "  " + how->second + "\n";
            continue;
        }
        const auto last = [&](const char* column) {
            const Column* c = t.find(column);
            return c && !c->values.empty() ? c->values.back() : std::numeric_limits<double>::quiet_NaN();
        };
        const auto place = [&](const char* x, const char* y, const char* z) {
            return "(" + number_in_words(last(x)) + ", " + number_in_words(last(y)) + ", " + number_in_words(last(z)) +
                   ")";
        };
        double most = 0, when = 0;
        const Column *fx = t.find("fx"), *fy = t.find("fy"), *fz = t.find("fz");
        for (std::size_t k = 0; fx && fy && fz && k < t.time.size(); ++k)
            if (const double f = Vec3(fx->values[k], fy->values[k], fz->values[k]).norm(); f > most)
                most = f, when = t.time[k];
        constexpr double rounding = 1e-7;  // [rad]: an arc cosine near 1 halves the digits
        const double turned = 2 * std::acos(std::clamp(std::abs(last("q0")), 0.0, 1.0));
        out += fmt::format(
            "body {} at {} s: centre at {} m, {} m below its start; {} m/s; turned by {} deg; largest force {} {} at "
            "{} s\n",
            body.name, number_in_words(t.time.back()), place("x", "y", "z"),
            number_in_words(body.motion.mass.centre.z() - last("z")), place("vx", "vy", "vz"),
            plain_degrees(turned < rounding ? 0 : turned, 4), number_in_words(most), scene.spanwise_unit("N"),
            number_in_words(when));
    }
    if (const auto how = record.attributes.find("mesh_motion"); how != record.attributes.end() && !out.empty())
        out += how->second + "\n";
    return out;
}

}  // namespace tw::app
