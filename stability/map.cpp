#include "stability/map.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

namespace tw {

namespace {

const std::vector<double> speeds = {8, 30, 80}, lengths = {1.33, 1.5, 2}, courants = {0.45, 0.7, 0.9, 1.2, 1.5, 1.8};

StabilityMap map_of(std::string title, const HardCase& base, MapAxis x, MapAxis y) {
    StabilityMap map{std::move(title), base, std::move(x), std::move(y), {}};
    for (const double yv : map.y.values)
        for (const double xv : map.x.values) {
            MapCell& cell = map.cells.emplace_back();
            cell.c = base;
            cell.c.*map.x.number = xv;
            cell.c.*map.y.number = yv;
        }
    return map;
}

}  // namespace

std::vector<StabilityMap> stability_maps(bool quick) {
    const double fineness = quick ? 0.5 : 1;
    HardCase impact, stream, tank;
    impact.c0_over_speed = 40;  // its jets run at four times the speed
    impact.spacings_per_m = 40 * fineness;
    stream.kind = HardCaseKind::stream;
    stream.deadrise_deg = 5;
    stream.c0_over_speed = 10;
    stream.spacings_per_m = 40 * fineness;
    tank.kind = HardCaseKind::tank;
    tank.speed = tank.deadrise_deg = 0;
    tank.c0_over_speed = 10;
    tank.spacings_per_m = quick ? 14 : 20;

    const MapAxis speed{"speed U [m/s]", &HardCase::speed, speeds},
        deadrise{"deadrise [deg]", &HardCase::deadrise_deg, {0, 2, 10, 20, 30, 45}},
        trim{"trim [deg]", &HardCase::deadrise_deg, {2, 5, 10, 20}}, h{"h/dp", &HardCase::h_over_dp, lengths},
        cfl{"Courant number", &HardCase::cfl, courants},
        zone{"zone [dp], 0: one size", &HardCase::zone, {0, 8, 16, 32}};
    MapAxis zone_of_tank = zone;
    zone_of_tank.values = {0, 8, 12, 16};  // wider, it fills the tank
    const auto c0 = [](const char* name, std::vector<double> values) {
        return MapAxis{name, &HardCase::c0_over_speed, std::move(values)};
    };
    return {
        map_of("Impact on a hull section: deadrise and speed", impact, deadrise, speed),
        map_of("Impact on a hull section: deadrise and sound speed", impact, deadrise, c0("c0/U", {4, 7, 10, 20, 40})),
        map_of("Impact on a hull section: time step and kernel", impact, cfl, h),
        map_of("Plate in a stream: time step and sound speed", stream, cfl, c0("c0/U", {2, 4, 7, 10, 20})),
        map_of("Plate in a stream: trim and speed", stream, trim, speed),
        map_of("Still tank: time step and kernel", tank, cfl, h),
        map_of("Still tank: time step and sound speed", tank, cfl, c0("c0/sqrt(2gH)", {4, 7, 10, 20})),
        map_of("Impact, two sizes of particles: deadrise and zone", impact, deadrise, zone),
        map_of("Plate in a stream, two sizes of particles: trim and zone", stream, trim, zone),
        map_of("Still tank, two sizes of particles: time step and zone", tank, cfl, zone_of_tank)};
}

bool run_stability_maps(std::vector<StabilityMap>& maps, int threads,
                        const std::function<void(const MapProgress&)>& show, const std::function<bool()>& stop) {
    struct Job {
        HardCase c;
        double work = 0, share_done = 0;
        MapCell result;
        bool done = false;
    };
    std::vector<Job> jobs;
    for (const StabilityMap& map : maps)
        for (const MapCell& cell : map.cells)
            if (std::ranges::find(jobs, cell.c, &Job::c) == jobs.end())
                jobs.push_back({cell.c, cell.c.predicted_work(), 0, {cell.c, {}, {}}, false});
    double all_work = 0;
    for (const Job& job : jobs) all_work += job.work;

    const auto began = std::chrono::steady_clock::now();
    std::mutex mutex;
    std::size_t next = 0, done = 0;
    bool stopped = false;
    std::exception_ptr error;
    const auto report = [&](const Job& job) {  // under the mutex
        MapProgress p;
        for (const Job& j : jobs) p.share += j.work * j.share_done / all_work;
        p.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        p.left = p.share > 0.01 ? p.seconds * (1 - p.share) / p.share : 0;
        p.done = done, p.all = jobs.size(), p.now = describe(job.c);
        if (show) show(p);
    };
    const auto work = [&] {
        try {
            for (;;) {
                Job* job = nullptr;
                {
                    const std::lock_guard lock(mutex);
                    if (next == jobs.size() || stopped || error) return;
                    job = &jobs[next++];
                }
                HardCaseRun run = run_hard_case(job->c, [&](double time) {
                    const std::lock_guard lock(mutex);
                    stopped = stopped || (stop && stop());
                    job->share_done = std::min(1.0, time / job->c.duration());
                    report(*job);
                    return !stopped;
                });
                const std::lock_guard lock(mutex);
                if (run.stopped) return;
                job->result.judgement = judge_stability(job->c, run);
                job->result.run = std::move(run);
                job->share_done = 1;
                ++done;
                report(*job);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!error) error = std::current_exception();
        }
    };
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    {
        std::vector<std::jthread> others;
        for (unsigned k = 0; k < (threads > 0 ? static_cast<unsigned>(threads) : cores); ++k) others.emplace_back(work);
    }
    if (error) std::rethrow_exception(error);
    if (stopped) return false;
    for (StabilityMap& map : maps)
        for (MapCell& cell : map.cells) cell = std::ranges::find(jobs, cell.c, &Job::c)->result;
    return true;
}

std::string describe(const HardCase& c) {
    const std::string sizes = c.zone > 0 ? fmt::format(", two sizes, zone {:g} dp", c.zone) : "";
    if (c.kind == HardCaseKind::tank)
        return fmt::format("tank, h/dp {:g}, CFL {:g}, c0/sqrt(2gH) {:g}{}", c.h_over_dp, c.cfl, c.c0_over_speed,
                           sizes);
    return fmt::format("{}, {:g} m/s, {:g} deg, h/dp {:g}, CFL {:g}, c0/U {:g}{}", to_string(c.kind), c.speed,
                       c.deadrise_deg, c.h_over_dp, c.cfl, c.c0_over_speed, sizes);
}

}  // namespace tw
