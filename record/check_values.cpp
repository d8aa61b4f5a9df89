#include "record/check_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/errors.h"

namespace tw {
namespace {

constexpr std::array positive{"near_hull", "spacing", "duration", "density", "length", "beam"};
constexpr std::array not_negative{"speed",
                                  "mean_from",
                                  "sampling_interval",
                                  "kinematic_viscosity",
                                  "write_interval",
                                  "raster_every",
                                  "wall_particles",
                                  "air_particles",
                                  "dimensions",
                                  "predicted_seconds",
                                  "predicted_elements",
                                  "predicted_memory",
                                  "gravity",
                                  "predicted_core_seconds"};

class Check {
public:
    explicit Check(const std::string& file) : file_(file) {}

    void finite(const std::string& key, double value) const {
        if (!std::isfinite(value)) refuse(key, value, "a finite number");
    }
    void at_least_zero(const std::string& key, double value) const {
        if (!(value >= 0) || std::isinf(value)) refuse(key, value, "a finite number, not below 0");
    }
    void above_zero(const std::string& key, double value) const {
        if (!(value > 0) || std::isinf(value)) refuse(key, value, "a finite number above 0");
    }
    template <class List, class TimeOf>
    void times(const std::string& key, const List& list, TimeOf time_of) const {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const double time = time_of(list[i]);
            finite(fmt::format("{}[{}]", key, i), time);
            if (i > 0 && time < time_of(list[i - 1]))
                refuse(fmt::format("{}[{}]", key, i), time,
                       fmt::format("no less than {} before it", time_of(list[i - 1])));
        }
    }

private:
    [[noreturn]] void refuse(const std::string& key, double value, const std::string& expected) const {
        throw InputError(fmt::format(
            "{}: {} = {}; expected {}: the record is damaged, or the program that wrote it is faulty; run it again",
            file_, key, value, expected));
    }
    const std::string& file_;
};

}  // namespace

void check_values(const std::string& file, const RunRecord& record) {
    const Check check(file);
    for (const auto& [name, value] : record.numbers) {
        const std::string key = "numbers/" + name;
        if (std::ranges::find(positive, name) != positive.end())
            check.above_zero(key, value);
        else if (std::ranges::find(not_negative, name) != not_negative.end())
            check.at_least_zero(key, value);
        else
            check.finite(key, value);
    }
    for (const auto& [name, table] : record.tables)
        check.times("tables/" + name + "/time", table.time, [](double t) { return t; });
    check.times("raster/time", record.frames, [](const RasterFrame& f) { return f.time; });
    for (const double x : record.raster.origin) check.finite("raster/origin", x);
    check.at_least_zero("raster/spacing", record.raster.voxel);
    for (const Vec3& p : record.hull.points)
        for (const double x : p) check.finite("hull/points", x);
    for (const BodyShape& body : record.bodies) {
        const std::string key = "bodies/" + body.table;
        for (const double x : body.centre) check.finite(key + "/centre", x);
        for (const Vec3& p : body.surface.points)
            for (const double x : p) check.finite(key + "/points", x);
    }
    for (const Phase& phase : record.phases) {
        check.at_least_zero("cost/" + phase.name + "/wall", phase.wall);
        check.at_least_zero("cost/" + phase.name + "/cpu", phase.cpu);
    }
    check.at_least_zero("cost/peak_memory", record.peak_memory);
    check.at_least_zero("cost/elements", record.elements);
    check.at_least_zero("cost/steps", record.steps);
    for (const ResolvedBox& r : record.resolution) {
        check.above_zero("resolution/size", r.size);
        for (const Vec3& corner : {r.box.min, r.box.max})
            for (const double x : corner) check.finite("resolution/box", x);
    }
    for (const EffectChoice& effect : record.effects) check.finite("effects/" + effect.name + "/cost", effect.cost);
    for (const RecordedCheck& line : record.validity_checks) {
        const std::string key = "certificate/" + line.name;
        check.finite(key + "/limit", line.limit);
        if (record.state == "failed") continue;
        check.finite(key + "/value", line.value);
        check.at_least_zero(key + "/time", line.time);
    }
}

}  // namespace tw
