#include <fmt/format.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "import/readers.h"
#include "record/raster.h"
#include "record/raster_grid.h"

namespace tw {

void read_water(const WaterSource& water, RunRecord& record) {
    const std::string file = water.source.string();
    if (RasterGrid(record.raster).empty() || record.numbers["dimensions"] == 2)
        throw InputError(fmt::format("{}: [water] needs a scene of three dimensions with a water raster", file));
    const CsvColumns csv(read_text(water.source), file);
    const std::vector<double> time = series_of(water.time, csv), x = series_of(water.x, csv),
                              y = series_of(water.y, csv), z = series_of(water.z, csv),
                              volume = series_of(water.volume, csv),
                              cell = water.cell ? series_of(*water.cell, csv) : volume;
    Raster raster(record.raster);
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const auto refuse = [&](const std::string& what) {
            throw InputError(fmt::format("{}:{}: {}", file, csv.line(i), what));
        };
        const Vec3 centre(x[i], y[i], z[i]);
        if (!std::isfinite(time[i]) || !centre.allFinite() || !std::isfinite(volume[i]) || !std::isfinite(cell[i]))
            refuse("a cell of [water] has no number; expected one in every row");
        if (!(volume[i] >= 0) || !(cell[i] >= volume[i] * (1 - 1e-9)))
            refuse(
                fmt::format("{:.6g} m3 of water in {:.6g} m3; expected no negative volume, and no more water than "
                            "cell",
                            volume[i], cell[i]));
        if (i > 0 && time[i] < time[i - 1])
            refuse(fmt::format("time {:.9g} s found after {:.9g} s; expected rows in the order of their times", time[i],
                               time[i - 1]));
        if (water.cell)
            raster.pour_cell(centre, cell[i], volume[i]);
        else
            raster.pour(centre, std::cbrt(volume[i]), volume[i]);
        if (i + 1 < csv.rows() && time[i + 1] == time[i]) continue;
        record.frames.push_back(raster.frame(time[i]));
        raster = Raster(record.raster);
    }
}

}  // namespace tw
