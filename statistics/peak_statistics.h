#pragma once
#include <optional>
#include <span>

namespace tw {

// What independent peaks say, one a period, with 95 % intervals that assume no distribution.

struct PeakValue {
    double value = 0, low = 0, high = 0;  ///< and the ends of its interval [unit of the peaks]
    double half_width() const;            ///< to the farther end
};

/// The value below which the share `p` (0 to 1) of all such peaks lies: of the sample at the place (n + 1/3) p + 1/3
/// (Hyndman & Fan 1996, type 8). Its interval is bounded by the nearest two of the ordered peaks, l and u, with
///
///   sum_{k=l}^{u-1} C(n, k) p^k (1 - p)^(n - k) >= 0.95
///
/// (David & Nagaraja 2003, Order Statistics, section 7.1). Nothing where no two of them bound it.
std::optional<PeakValue> quantile_of_peaks(std::span<const double> peaks, double p);
/// How many peaks bound it at least: 1 - p^n - (1 - p)^n >= 0.95.
int fewest_peaks_for(double p);

inline constexpr int fewest_peaks_for_third = 9;
/// Mean of the highest third of them; its interval from 2000 samples drawn from the peaks with replacement, always the
/// same ones. Nothing of fewer than nine.
std::optional<PeakValue> highest_third(std::span<const double> peaks);

/// `events` in `periods` (at least one): its interval is that of Clopper & Pearson for the share, times the periods.
PeakValue count_of_events(int events, int periods);

}  // namespace tw
