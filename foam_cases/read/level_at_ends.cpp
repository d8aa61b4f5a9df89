#include "foam_cases/read/level_at_ends.h"

#include <algorithm>
#include <cmath>

#include "scene/box/forcing_zones.h"
#include "statistics/whole_periods.h"

namespace tw {

LevelAtEnds::LevelAtEnds(const Scene& scene)
    : scene_(scene), ends_{End{.name = "level_at_inlet"}, End{.name = "level_at_outlet"}} {
    watched_ = scene.motion.kind == Motion::Kind::stream && scene.water_blocks.empty() && scene.bodies.empty() &&
               !scene.hull_is_free() && !forcing_zones(scene).zones.empty();
    const Box& box = scene.domain.undamped;
    const double tenth = box.size().x() / 10;
    ends_[0].low = box.min.x(), ends_[0].high = box.min.x() + tenth;
    ends_[1].low = box.max.x() - tenth, ends_[1].high = box.max.x();
}

void LevelAtEnds::add(const Vec3& cell, double volume, double water) {
    if (!watched_) return;
    for (End& end : ends_)
        if (cell.x() > end.low && cell.x() < end.high) end.more += water - (cell.z() < 0 ? volume : 0);
}

void LevelAtEnds::keep(RunRecord& record) const {
    if (!watched_) return;
    Table& samples = record.table("samples");
    const double across = scene_.domain.box.size().y();
    for (const End& end : ends_)
        samples.set(samples.time.size() - 1, end.name, "m", end.more / ((end.high - end.low) * across));

    const std::vector<double>& level = samples.find(ends_[0].name)->values;
    double sum = 0, from = scene_.sampling.mean_from;
    int count = 0;
    if (scene_.wave) {  // of whole periods, since mean_from
        const double end = samples.time.back(), period = scene_.wave->encounter_period();
        const int whole = whole_periods(from, end, period);
        if (whole >= 1) from = end - (whole - 1e-6) * period;
    }
    for (std::size_t i = 0; i < level.size(); ++i)
        if (samples.time[i] >= from) sum += level[i], ++count;
    if (count == 0) return;
    const double depth = -scene_.domain.box.min.z();
    const RecordedCheck line{inlet_level_line, "% of the depth", 100 * std::abs(sum / count) / depth, 1,
                             samples.time.back()};
    const auto known = std::ranges::find(record.validity_checks, line.name, &RecordedCheck::name);
    if (known == record.validity_checks.end())
        record.validity_checks.push_back(line);
    else
        *known = line;
}

}  // namespace tw
