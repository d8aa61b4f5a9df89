#include <fmt/format.h>

#include <algorithm>

#include "compare/report/page.h"
#include "compare/report/report_table.h"
#include "record/code_version.h"
#include "stability/heat_map.h"
#include "stability/report.h"
#include "stability/tables.h"

namespace tw {

std::string stability_html(const std::vector<StabilityMap>& maps, bool quick) {
    std::string style =
        ".cell{padding:1px 9px;border-radius:10px;font-size:13px;color:#1b1f24}figure{margin:14px 0}figure "
        "svg{max-width:100%;height:auto}";
    for (const Stability s : {Stability::stable, Stability::warned, Stability::failed})
        style += fmt::format(".{}{{background:{}}}", to_string(s), colour_of(s));
    const StabilityCounts n = count(maps);
    std::string out = page_begin("Stability map of the particle solver", style) +
                      "<h1>Stability map of the particle solver</h1>" +
                      fmt::format("<p class=\"sub\">twinwake {}{}</p>", escaped(TWINWAKE_CODE_VERSION),
                                  quick ? ", --quick: half as fine" : "");
    out += fmt::format(
        "<p class=\"verdict\">{} cells <span class=\"cell stable\">stable</span>, {} <span class=\"cell "
        "warned\">warned</span>, {} <span class=\"cell failed\">failed</span>.</p>"
        "<p>Each cell is a small run in two dimensions of the solver that runs scenes. Stable: it came to its end "
        "within "
        "all limits. Warned: it came to its end, and its validity checks say that its results are not to be trusted, "
        "most "
        "often because the sound speed is too low. Failed: the solver stopped it, or it violated a physical law. The "
        "letters in a "
        "cell are the check that came nearest to its limit or went farthest beyond it: Ma Mach number, rho density, E "
        "energy made, KE motion of still water, p pressure error. The stated limit of the Courant number is {:g}.</p>",
        n.stable, n.warned, n.failed, stated_courant_limit);
    out +=
        "<ul><li><strong>Impact</strong>: a block of water, 2 m by 1 m, meets a hull section 1 m wide with hard "
        "chines; "
        "until it has moved by its height.</li>"
        "<li><strong>Stream</strong>: a plate 1 m long planes on a stream between inlet and outlet, lower edge 0.1 m "
        "deep, bow face upright; until the water has gone through twice.</li>"
        "<li><strong>Still tank</strong>: 3 m long, 1 m deep, for 40 sqrt(depth / g) = 12.8 s.</li></ul>";
    for (const StabilityMap& map : maps) {
        const bool tank = map.base.kind == HardCaseKind::tank;
        out += "<figure>" + heat_map(map).svg + "<figcaption>" +
               escaped(fmt::format("What is not on the axes: {}; {:g} spacings to the metre{}", describe(map.base),
                                   map.base.spacings_per_m, tank ? "." : ", the section's or plate's width.")) +
               "</figcaption></figure>";
    }
    return out + html_of(unstable_cells(maps)) + html_of(limits_of_the_map()) + page_end;
}

std::string stability_svg(const std::vector<StabilityMap>& maps) {
    // two to a row
    constexpr int gap = 12;
    int width = 0, y = 0, row_width = 0, row_height = 0;
    std::string drawn;
    for (std::size_t k = 0; k < maps.size(); ++k) {
        if (k % 2 == 0) y += row_height > 0 ? row_height + gap : 0, row_width = row_height = 0;
        const HeatMap one = heat_map(maps[k]);
        const int x = k % 2 == 0 ? 0 : row_width + gap;
        drawn += fmt::format("<g transform=\"translate({} {})\">{}</g>", x, y, one.svg);
        row_width = x + one.width, row_height = std::max(row_height, one.height);
        width = std::max(width, row_width);
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\"><rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>{2}</svg>\n",
        width, y + row_height, drawn);
}

}  // namespace tw
