#include "foam_cases/axis_cells.h"

#include <algorithm>
#include <cmath>

#include "scene/mesh/mesh_cells.h"

namespace tw {
namespace {

/// A block for a zone behind the last plane or before the first, of cells that grow outwards.
void add_zone(AxisCells& axis, const ForcingZone& zone, double cell) {
    const double width = std::abs(zone.end - zone.begin);
    const int cells = std::max(1, static_cast<int>(std::lround(cells_along_zone(width, cell))));
    const double grows = std::pow(growth_in_zones, cells - 1);
    axis.planes.insert(zone.high ? axis.planes.end() : axis.planes.begin(), zone.end);
    axis.cells.insert(zone.high ? axis.cells.end() : axis.cells.begin(), cells);
    axis.grows.insert(zone.high ? axis.grows.end() : axis.grows.begin(), zone.high ? grows : 1 / grows);
}

}  // namespace

AxisCells split_axis(double low, double high, double spacing, std::vector<double> wanted) {
    AxisCells axis;
    std::sort(wanted.begin(), wanted.end());
    axis.planes = {low};
    for (const double plane : wanted) {
        const auto fits = [&](double from, double to) {  // both in whole cells within 25 %
            const double n = (to - from) / spacing;
            return n > 0.75 && std::abs(n / std::max(1.0, std::round(n)) - 1) <= 0.25;
        };
        if (plane > low && plane < high && fits(axis.planes.back(), plane) && fits(plane, high))
            axis.planes.push_back(plane);
    }
    axis.planes.push_back(high);
    for (std::size_t i = 1; i < axis.planes.size(); ++i)
        axis.cells.push_back(
            std::max(1, static_cast<int>(std::lround((axis.planes[i] - axis.planes[i - 1]) / spacing))));
    axis.grows.assign(axis.cells.size(), 1);
    return axis;
}

AxisCells axis_with_zones(const Scene& scene, int axis, double cell, const std::vector<double>& wanted) {
    double low = scene.domain.box.min[axis], high = scene.domain.box.max[axis];
    std::vector<ForcingZone> zones = grown_zones(scene);
    std::erase_if(zones, [&](const ForcingZone& zone) { return zone.axis != axis; });
    for (const ForcingZone& zone : zones) (zone.high ? high : low) = zone.begin;
    AxisCells cells = split_axis(low, high, cell, wanted);
    for (const ForcingZone& zone : zones) add_zone(cells, zone, cell);
    return cells;
}

}  // namespace tw
