#pragma once
#include <span>
#include <string>

#include "compare/report/report_table.h"
#include "spray/droplet.h"

namespace tw::spray {

/// One of two sprays.
struct NamedSpray {
    std::string name;
    std::span<const Droplet> droplets;
};
/// Statistics of two sprays side by side: numbers, diameters, speeds, directions, energy, and how far the distributions
/// of size and speed are apart by Kolmogorov and Smirnov: the largest difference of the shares below any value. Droplets
/// of two methods have no names in common, so no more than their statistics can be compared.
ReportTable two_sprays(const NamedSpray& one, const NamedSpray& other, const Liquid& liquid);

/// Largest difference between the shares of two samples that lie below any value [-]; both sorted, neither empty, none
/// negative. Values within a millionth count as equal.
double largest_share_difference(std::span<const double> a, std::span<const double> b);

}  // namespace tw::spray
