#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/read_file.h"
#include "compare/compare.h"
#include "compare/report/report_files.h"
#include "compare/report/svg_plot.h"

namespace tw {
namespace fs = std::filesystem;

ReportFiles write_report(const Comparison& comparison, const fs::path& folder, const std::string& details) {
    make_own_folder(folder / "figures");
    const Figures figures = draw_figures(comparison);
    for (const auto* list : {&figures.forces, &figures.splash, &figures.wetting, &figures.cuts, &figures.probes,
                             &figures.bodies, &figures.maps, &figures.resolution})
        for (const Figure& f : *list)
            if (const std::string text = svg_file(f.plot.svg); !text.empty())
                write_text_atomically(folder / "figures" / (f.file + ".svg"), text);
    for (std::size_t s = 0; s < figures.pictures.free_surface.size(); ++s) {
        if (!figures.pictures.free_surface[s].empty())
            write_text_atomically(folder / "figures" / fmt::format("free_surface_{}.png", s),
                                  figures.pictures.free_surface[s]);
        if (!figures.pictures.hull_pressure[s].empty())
            write_text_atomically(folder / "figures" / fmt::format("hull_pressure_{}.png", s),
                                  figures.pictures.hull_pressure[s]);
    }
    write_text_atomically(folder / "quantities.csv", quantities_csv(comparison));
    write_text_atomically(folder / "series.csv", series_csv(comparison));
    const ReportFiles files{folder / "report.html", folder / "report.json", folder / "quantities.csv"};
    write_text_atomically(files.json, comparison_json(comparison));
    write_text_atomically(files.html, report_html(comparison, figures, details));
    return files;
}

}  // namespace tw
