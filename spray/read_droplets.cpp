#include "spray/read_droplets.h"

#include <fmt/format.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "text/csv_columns.h"

namespace tw::spray {

std::vector<Droplet> read_droplets(const std::filesystem::path& file) {
    const CsvColumns csv(read_text(file), file.string());
    const auto &x = csv.values("x [m]"), &y = csv.values("y [m]"), &z = csv.values("z [m]"), &u = csv.values("u [m/s]"),
               &v = csv.values("v [m/s]"), &w = csv.values("w [m/s]"), &d = csv.values("diameter [m]"),
               &t = csv.values("time [s]");
    std::vector<Droplet> droplets;
    constexpr double largest = 1e9;  // [m], [m/s], [s]
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        for (const double number : {x[i], y[i], z[i], u[i], v[i], w[i], d[i], t[i]})
            if (!(std::abs(number) <= largest))
                throw InputError(fmt::format("{}:{}: {:g} found; expected a number in every column, none beyond {:g}",
                                             file.string(), csv.line(i), number, largest));
        if (!(d[i] > 0))
            throw InputError(
                fmt::format("{}:{}: a diameter of {:g} m; expected above 0", file.string(), csv.line(i), d[i]));
        droplets.push_back({{x[i], y[i], z[i]}, {u[i], v[i], w[i]}, d[i], t[i]});
    }
    return droplets;
}

}  // namespace tw::spray
