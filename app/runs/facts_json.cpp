#include "app/runs/facts_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/runs/ranks.h"
#include "compare/grid_study/grid_study_report.h"
#include "methods/names.h"
#include "scene/box/box_walls.h"
#include "scene/cost/program_memory.h"
#include "scene/doubtful_input.h"
#include "scene/particles/cost_of_sizes.h"

namespace tw::app {
namespace {

using Json = nlohmann::ordered_json;

std::string written(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

Json vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json box(const Box& b) { return {{"min", vec(b.min)}, {"max", vec(b.max)}}; }

Json findings_json(const std::vector<Finding>& findings) {
    static constexpr const char* levels[] = {"note", "warning", "error"};
    Json list = Json::array();
    for (const Finding& f : findings)
        list.push_back({{"level", levels[static_cast<int>(f.level)]},
                        {"name", f.name},
                        {"message", f.message},
                        {"mendable", f.mendable},
                        {"place", vec(f.place)}});
    return list;
}

Json list_of(const std::vector<RunFacts>& runs) {
    Json list = Json::array();
    for (const RunFacts& r : runs)
        list.push_back({{"method", r.method},
                        {"state", r.state},
                        {"reason", r.reason},
                        {"record", r.record},
                        {"elements", r.elements},
                        {"steps", r.steps},
                        {"wall", r.wall}});
    return list;
}

Json passes_json(const std::vector<PassesPace>& paces) {
    Json list = Json::array();
    for (const PassesPace& p : paces)
        list.push_back(
            {{"isa", p.passes->isa}, {"lanes", p.passes->lanes}, {"evaluations_per_second", p.evaluations_per_second}});
    return list;
}

Json posed_hull_json(const Scene& scene) {
    if (!scene.hull) return Json::object();
    const Hull& h = *scene.hull;
    return {{"source", h.source},
            {"hash", h.hash},
            {"length", h.length},
            {"beam", h.beam},
            {"trim", h.trim},
            {"draft", h.draft},
            {"half", h.half},
            {"displacement", h.still.volume},
            {"findings", findings_json(h.findings)},
            {"repairs", h.repairs}};
}

Json effects_json(const Scene& scene) {
    Json effects = Json::array();
    for (const EffectChoice& e : scene.effects) {
        Json bounds = Json::array();
        for (const EffectBound& b : e.bounds)
            bounds.push_back({{"of", b.of},
                              {"below", b.below},
                              {"above", b.above},
                              {"unit", b.unit},
                              {"source", b.source},
                              {"elements", b.elements}});
        effects.push_back({{"name", e.name},
                           {"on", e.on},
                           {"forced", e.forced},
                           {"reason", e.reason},
                           {"influence", e.influence},
                           {"bounds", bounds},
                           {"cost", e.cost}});
    }
    return effects;
}

Json refinement_json(const Scene& scene) {
    Json refinement = Json::array();
    for (const RefinementBox& r : scene.refinement)
        refinement.push_back({{"name", r.name}, {"level", r.level}, {"box", box(r.box)}});
    return refinement;
}

/// The particles of each size, and what they take of the run.
Json sizes_json(const Scene& scene, const Prediction& p) {
    Json sizes = Json::array();
    for (const CostOfSize& s : cost_of_sizes(scene, p, p.of(sph_method)))
        sizes.push_back({{"spacing", s.particles.spacing},
                         {"active", std::round(s.particles.active)},
                         {"guards", std::round(s.particles.guards)},
                         {"parents", std::round(s.particles.parents)},
                         {"bytes", s.bytes},
                         {"seconds", s.seconds},
                         {"dt", s.dt}});
    return sizes;
}

Json costs_json(const Scene& scene, const Prediction& p) {
    Json predicted = Json::object();
    for (const std::string& method : scene.run.methods) {
        const MethodCost& cost = p.of(method);
        predicted[method] = {{"seconds", cost.seconds},
                             {"core_seconds", cost.core_seconds},
                             {"bytes", all_bytes(scene, cost)},
                             {"steps", std::round(cost.steps)}};
        if (method == sph_method) predicted[method]["sizes"] = sizes_json(scene, p);
    }
    return predicted;
}

Json ranks_json(const RanksTake& ranks) {
    Json of_ranks = {{"number", ranks.ranks}};
    if (ranks.ranks > 1)
        of_ranks.update({{"particles", ranks.particles},
                         {"copies", ranks.copies},
                         {"bytes", ranks.bytes},
                         {"bytes_at_start", ranks.bytes_at_start},
                         {"seconds", ranks.seconds}});
    return of_ranks;
}

}  // namespace

std::string passes_line(std::vector<PassesPace> paces) {
    std::ranges::sort(paces, std::greater{}, &PassesPace::evaluations_per_second);
    std::string line;
    for (const PassesPace& p : paces)
        line += fmt::format("{}{} {:.2g}", line.empty() ? "" : ", ", p.passes->isa, p.evaluations_per_second / 1e6);
    return line + " million evaluations/s";
}

std::string check_json(const Scene& scene, const Prediction& p, const RanksTake& ranks) {
    const WallEffect walls = wall_effect(scene);
    return written({{"title", scene.title},
                    {"scene_hash", scene.hash},
                    {"particles", std::round(p.particles)},
                    {"particles_at_start", std::round(p.particles_at_start)},
                    {"most_particles", std::round(p.most_particles)},
                    {"wall_particles", std::round(p.wall_particles)},
                    {"air_particles", std::round(p.air_particles)},
                    {"cells", std::round(p.cells)},
                    {"findings", findings_json(doubtful_input(scene))},
                    {"hull", posed_hull_json(scene)},
                    {"domain", box(scene.domain.box)},
                    {"walls", {{"of", walls.of}, {"change", walls.change}}},
                    {"spacing", scene.resolution.spacing},
                    {"near_hull", scene.resolution.near_hull},
                    {"refinement", refinement_json(scene)},
                    {"duration", scene.run.duration},
                    {"stop", scene.run.stop},
                    {"mean_from", scene.sampling.mean_from},
                    {"ramp", scene.motion.ramp},
                    {"c0", scene.sph.c0},
                    {"effects", effects_json(scene)},
                    {"predicted", costs_json(scene, p)},
                    {"ranks", ranks_json(ranks)}});
}

std::string hull_json(const HullFacts& f) {
    return written({{"source", f.source},
                    {"hash", f.hash},
                    {"points", f.points},
                    {"triangles", f.triangles},
                    {"bounds", box(f.bounds)},
                    {"volume", f.mass.volume},
                    {"area", f.mass.area},
                    {"centroid", vec(f.mass.centroid)},
                    {"findings", findings_json(f.findings)},
                    {"repairs", f.repairs},
                    {"solids", f.solids},
                    {"usable", f.usable}});
}

std::string doctor_json(const MachineFacts& f) {
    Json openfoam = Json::array();
    for (const OpenFoam& o : f.openfoam)
        openfoam.push_back({{"solver", o.command()},
                            {"project_dir", o.project_dir.string()},
                            {"version", o.version},
                            {"vendor", o.vendor},
                            {"loaded", o.loaded},
                            {"sound", o.sound},
                            {"self_test_error", o.self_test_error},
                            {"verdict", o.verdict}});
    return written({{"version", f.version},
                    {"built_with", f.built_with},
                    {"compilers", f.compilers},
                    {"processor", f.processor},
                    {"isa", f.isa},
                    {"cores", f.cores},
                    {"memory", f.memory},
                    {"gpu", f.gpu},
                    {"gpu_reason", f.gpu_reason},
                    {"gpu_verdict", f.gpu_verdict},
                    {"gpu_error", f.gpu_error},
                    {"gpu_pace", f.gpu_pace},
                    {"mpirun", f.mpirun},
                    {"pace", f.pace},
                    {"passes", passes_json(f.passes)},
                    {"chosen_passes", f.chosen_passes},
                    {"openfoam", openfoam},
                    {"sound", f.sound}});
}

std::string runs_json(const std::vector<RunFacts>& runs) { return written({{"runs", list_of(runs)}}); }

std::string run_json(const Comparison& comparison, const std::vector<RunFacts>& runs, const GridStudy* grid_study) {
    Json all = Json::parse(comparison_json(comparison));
    all["runs"] = list_of(runs);
    if (grid_study) all["ladder"] = Json::parse(grid_study_json(*grid_study));
    return written(all);
}

std::string bench_json(const BenchResult& r, const std::vector<PassesPace>& passes) {
    return written({{"particles", r.particles},
                    {"neighbours_per_particle", r.neighbours_per_particle},
                    {"threads", r.threads},
                    {"isa", r.isa},
                    {"evaluations_per_second", r.evaluations_per_second},
                    {"pairs_per_second", r.pairs_per_second},
                    {"bytes_per_particle", r.bytes_per_particle},
                    {"bytes_on_device", r.bytes_on_device},
                    {"share_of_kernel_peak", r.share_of_kernel_peak},
                    {"share_outside_pairs", r.share_outside_pairs},
                    {"passes", passes_json(passes)}});
}

}  // namespace tw::app
