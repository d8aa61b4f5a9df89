#include "stability/report.h"

#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/terminal/progress_bar.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "base/folder_lock.h"

namespace tw::app {

int run_stability(const StabilityCommand& command, const Common& common) {
    namespace fs = std::filesystem;
    const fs::path out = command.out.empty() ? fs::path("runs/stability") : command.out;
    catch_stop_signals();
    std::error_code wrong;  // an impossible folder is refused before the work
    if (fs::create_directories(out, wrong); wrong)
        throw InputError("--out " + out.string() + ": no folder can be made there: " + wrong.message());
    const FolderLock lock(out);
    std::vector<StabilityMap> maps = stability_maps(command.quick);
    {
        ProgressBar bar("stability", common.quiet);
        const auto show = [&bar](const MapProgress& p) {
            bar.show(p.share, p.seconds, p.left, fmt::format("{} of {} cases", p.done, p.all), p.now);
        };
        if (!run_stability_maps(maps, command.threads, show, stop_asked)) {
            complain("stability: stopped on request; nothing was written");
            return run_failed;
        }
    }
    const std::string json = stability_json(maps, command.quick);
    write_file(out / "stability.html", stability_html(maps, command.quick));
    write_file(out / "stability.svg", stability_svg(maps));
    write_file(out / "stability.json", json + "\n");
    write_file(out / "stability.txt", stability_text(maps));
    say(common, stability_text(maps) + "map: " + (out / "stability.html").string() + "\n");
    write_json(common, json);
    return done;
}

}  // namespace tw::app
