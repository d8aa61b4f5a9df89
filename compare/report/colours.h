#pragma once
#include <array>
#include <string>
#include <vector>

namespace tw {

using Rgb = std::array<double, 3>;  ///< 0..1

/// A colour scale through evenly spaced colours, the same for pictures, maps and legends.
class ColourScale {
public:
    explicit ColourScale(std::vector<Rgb> stops, double low, double high)
        : stops_(std::move(stops)), low_(low), high_(high) {}
    Rgb operator()(double value) const;  ///< clamped to the ends
    const std::vector<Rgb>& stops() const { return stops_; }
    double low() const { return low_; }
    double high() const { return high_; }
    /// A labelled bar as <svg>.
    std::string legend(const std::string& label) const;

private:
    std::vector<Rgb> stops_;
    double low_, high_;
};

/// Deep blue below, pale at the middle, to warm above: elevation about still water.
ColourScale elevation_scale(double half_range, double middle);
/// Dark to bright: pressure.
ColourScale pressure_scale(double low, double high);

}  // namespace tw
