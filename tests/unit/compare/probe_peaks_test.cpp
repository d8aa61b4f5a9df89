#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compare/metrics/probes.h"

namespace tw {
namespace probe_peaks_test {

struct Series {
    std::vector<double> t, x;
};
/// f(t) from 0 to `end`, in steps that grow by a per mille each: no two are alike.
Series sampled(double end, auto&& f) {
    Series s;
    for (double t = 0, step = 1e-4; t < end; t += step, step *= 1.001) s.t.push_back(t), s.x.push_back(f(t));
    s.t.push_back(end), s.x.push_back(f(end));
    return s;
}

TEST(ProbePeaks, TheWindowsMeanOfARampIsThatOfItsLastPart) {
    const Series ramp = sampled(2, [](double t) { return 100 * t; });
    EXPECT_NEAR(largest_window_mean(ramp.t, ramp.x, 0.5), 175, 1e-6);
    EXPECT_NEAR(largest_window_mean(ramp.t, ramp.x, 2), 100, 1e-6);
    EXPECT_TRUE(std::isnan(largest_window_mean(ramp.t, ramp.x, 2.5)));
}

TEST(ProbePeaks, TheWindowsMeanOfABellIsItsMiddles) {
    const Series bell = sampled(2, [](double t) { return std::exp(-std::pow((t - 1) / 0.1, 2)); });
    const double exact = std::sqrt(3.14159265) * 0.1 / 0.2 * std::erf(1);  // over 0.2 s round the middle
    EXPECT_NEAR(largest_window_mean(bell.t, bell.x, 0.2), exact, 1e-4 * exact);
}

TEST(ProbePeaks, AGapEndsAStretch) {
    Series s{{0, 1, 2, 3, 4, 5}, {9, std::nan(""), 1, 2, 3, std::nan("")}};
    EXPECT_NEAR(largest_window_mean(s.t, s.x, 1), 2.5, 1e-12);
    EXPECT_TRUE(std::isnan(largest_window_mean(s.t, s.x, 3)));
    EXPECT_TRUE(std::isnan(time_percentile({}, {}, 0.99)));
}

TEST(ProbePeaks, PercentilesAreOfTimeNotOfSamples) {
    const Series ramp = sampled(2, [](double t) { return 100 * t; });
    EXPECT_NEAR(time_percentile(ramp.t, ramp.x, 0.99), 198, 1e-6);
    EXPECT_NEAR(time_percentile(ramp.t, ramp.x, 0.5), 100, 1e-6);
}

TEST(ProbePeaks, ArrivalIsBetweenTheSamples) {
    const Series step{{0, 1, 2}, {0, 0, 10}};
    EXPECT_NEAR(arrival_time(step.t, step.x, 1), 1.1, 1e-12);
    EXPECT_TRUE(std::isnan(arrival_time(step.t, step.x, 11)));
    EXPECT_EQ(arrival_time(step.t, step.x, -1), 0) << "it was there";
}

}  // namespace probe_peaks_test
}  // namespace tw
