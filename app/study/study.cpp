#include "app/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "app/arguments/output.h"
#include "app/progress/member_state.h"
#include "app/study/study_keys.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/read_file.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;
using StudyJson = nlohmann::ordered_json;

StudyJson json_of(const SceneOverrides& o) {
    StudyJson json = StudyJson::object();
    if (o.hull_file) json["hull"] = o.hull_file->string();
    for (const auto& [key, value] : given_in_study)
        if (o.*value) json[key] = *(o.*value);
    for (const auto& [key, factor] : factors_in_study)
        if (o.*factor != 1) json[key] = o.*factor;
    if (!o.effects.empty()) json["effects"] = o.effects;
    if (!o.device.empty()) json["device"] = o.device;
    if (!o.interface.empty()) json["interface"] = o.interface;
    if (o.wave_twin) json["wave_twin"] = true;
    return json;
}

StudyJson json_of(const Member& m) {
    const int cores = m.request.ranks * cores_of_rank(m);
    return {{"name", m.name},
            {"method", m.method},
            {"folder", m.folder.string()},
            {"scene", m.request.file.string()},
            {"changes", json_of(m.request.overrides)},
            {"numbers", m.request.numbers},
            {"methods", m.request.method},
            {"threads", m.request.threads},
            {"ranks", m.request.ranks},
            {"cores", cores},
            {"snapshots", m.request.snapshots},
            {"needs", StudyJson::array()},
            {"predicted", {{"seconds", m.seconds}, {"bytes", m.bytes}, {"elements", m.elements}}}};
}

}  // namespace

int job_cores(double elements, int most) {
    return static_cast<int>(
        std::bit_floor(static_cast<unsigned>(std::clamp(elements / elements_per_job_core, 1.0, double(most)))));
}

int cores_of_rank(const Member& member, int most) {
    const RunRequest& r = member.request;
    return r.threads > 0 ? r.threads : job_cores(member.elements / r.ranks, most);
}

void write_study(const Study& study) {
    const fs::path members = study_folder(study.out) / "members";
    std::error_code ignored;
    fs::remove_all(members, ignored);
    leaving_files([&] { make_own_folder(members.parent_path()); });
    make_folder(members);
    StudyJson json = {{"where", fs::current_path().string()},
                      {"out", study.out.string()},
                      {"program", fs::read_symlink("/proc/self/exe").string()},
                      {"report", study.words},
                      {"overwrite", study.overwrite},
                      {"take_finished", study.take_finished}};
    for (const Member& m : study.members) json["members"].push_back(json_of(m));
    try {
        write_file(study_folder(study.out) / "study.json", json.dump(1) + "\n");
    } catch (const StudyJson::exception&) {
        throw InputError(study.out.string() + ": a study made by several processes needs names of files in UTF-8");
    }
}

std::string why_unfinished(const fs::path& out, const fs::path& folder) {
    if (!fs::exists(study_folder(out) / "study.json")) return "not made yet";
    const Study study = read_study(out);
    for (std::size_t k = 0; k < study.members.size(); ++k) {
        if (study.members[k].folder != folder) continue;
        const MemberState state = read_member_state(state_file(out, k));
        if (!state.why.empty()) return state.why;
        if (state.kind == MemberState::Kind::waiting) return "not begun";
        return fmt::format("{} at {:.0f} %; its output: {}",
                           state.kind == MemberState::Kind::running ? "did not end, last seen" : name_of(state.kind),
                           100 * state.share, log_file(out, k).string());
    }
    return "not part of the study that was made";
}

}  // namespace tw::app
