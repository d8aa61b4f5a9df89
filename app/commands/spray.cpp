#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/arguments/output.h"
#include "app/commands/spray_cloud.h"
#include "base/atomic_file.h"
#include "base/folder_lock.h"
#include "spray/read_droplets.h"
#include "spray/read_study.h"
#include "spray/report/write_spray.h"

namespace tw::app {
namespace {

using Json = nlohmann::ordered_json;

Json interval_json(const spray::Interval& i) { return {i.low, i.high}; }

std::string spray_json(const spray::SprayResult& r) {
    Json ends = Json::object();
    for (const spray::Landing& l : r.landings) {
        const std::string name = l.fate == spray::Fate::hit ? r.target_names[static_cast<std::size_t>(l.target)]
                                                            : std::string(spray::to_string(l.fate));
        ends[name] = ends.value(name, 0) + 1;
    }
    Json json = {{"droplets", r.droplets.size()},
                 {"taken_volume", r.extraction.ledger.taken.volume},
                 {"droplet_volume", r.extraction.ledger.droplets.volume},
                 {"ends", ends}};
    if (r.peak) {
        const spray::Estimate& e = r.peak->estimate;
        json["sensor"] = {{"from", r.peak->window.from},
                          {"droplets", e.droplets},
                          {"enough_droplets", e.droplets >= spray::Estimate::enough},
                          {"outside_law", e.outside},
                          {"peak", e.peak},
                          {"average", e.average},
                          {"monte_carlo", e.monte_carlo},
                          {"corrected", e.corrected},
                          {"direct_mean", e.direct_mean},
                          {"direct_peak", e.direct_peak},
                          {"average_interval", interval_json(r.peak->droplets.average)},
                          {"corrected_interval", interval_json(r.peak->droplets.corrected)},
                          {"average_interval_over_windows", interval_json(r.over_windows.average)}};
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

int run_spray_command(const SprayCommand& command, const Common& common) {
    spray::SprayStudy study = spray::read_spray_study(command.study);
    if (!command.against.empty()) {
        study.against_name = std::filesystem::weakly_canonical(command.against).filename().string();
        study.against = spray::read_droplets(command.against / "droplets.csv");
    }
    const std::filesystem::path out =
        command.out.empty() ? std::filesystem::path("runs") / (command.study.stem().string() + "_spray") : command.out;
    const spray::SprayResult result = spray::run_spray(study);
    make_folder(out);
    const FolderLock lock(out);
    leaving_files([&] { spray::write_spray(out, study, result); });
    std::string text;
    for (const ReportTable& table : spray_tables(study, result))
        if (table.title != "Load in time") text += text_of(table) + "\n";
    if (!command.cloud.empty()) {
        const ReportTable cloud = fly_in_openfoam(study, result, command.cloud);
        leaving_files([&] { write_text_atomically(out / "cloud.csv", csv_of(cloud)); });
        text += text_of(cloud) + "\n";
        if (cloud.empty()) text += cloud.notes.front() + "\n\n";
    }
    say(common, text + "report: " + (out / "report.html").string() + "\n");
    write_json(common, spray_json(result));
    return done;
}

}  // namespace tw::app
