#pragma once
#include <complex>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "compare/compare.h"
#include "compare/metrics/gauge_sides.h"
#include "compare/metrics/wave_samples.h"

namespace tw {

/// Of records with a regular wave (number wave_period), from its height gauges, over the last whole periods that all
/// records cover, from mean_from on:
///   wave_height:GAUGE, wave_crest:GAUGE, wave_trough:GAUGE   mean over the periods, of each of which a mean and three
///                        harmonics are fitted, with its 95 % interval from how far the periods differ [m]; the theory's
///                        values stand beside as references
///   heave_response:BODY, pitch_response:BODY   first harmonic of a body's motion over half of the wave's height as asked
///                        for and over that wave's slope pi H / L, mean over the periods with its 95 % interval [-]
///   heave_over_wave:BODY, pitch_over_wave:BODY   of records that were given their empty twin (record/wave_twin.h): the
///                        same over the first harmonic a of the wave at the body's place in that twin and over its slope
///                        k a, both of the same period, so that what changes from period to period in both cancels [-]
///   wave_without:BODY    that wave, 2 a [m]
///   heave_response:hull, pitch_response:hull   the same of a hull that is free in heave and pitch in a stream, and
///   heave_phase:hull, pitch_phase:hull   by how much they are before the theory's crest at its centre of mass [deg]
///   wave_reflection      |a_r| / |a_i| of the first harmonics at two gauges or more, of those before an obstacle where
///                        some are behind it [%]: of two by split_waves over the
///                        whole time, of more by split_decaying_waves of each period, with the 95 % interval of the mean of
///                        the complex ratio over the periods; in a stream, where a wave that runs back has another length,
///                        there is none
///   wave_transmission    |a_i| behind an obstacle over |a_i| before it (gauge_sides.h), each by split_waves, mean over the
///                        periods [%]; of a single gauge behind it the amplitude of all that is there
///   wave_force_x, wave_force_z   of what stands fixed, a hull that is held too, without bodies: amplitude of the first
///                        harmonic; in oblique waves wave_force_y too [N]
///   wave_force_phase_x, _y, _z   by how much it is before the theory's crest at x = y = 0 [deg]
///   wave_drift_x, _y             mean force along x, and y [N]
///   wave_force_over_wave_x, _z   of a single obstacle whose empty twin the records were given: that amplitude over the one
///                        of the wave at its place in that twin, of the same period [N/m]; wave_force_lead_x, _z: the phase
///                        before that wave's crest [deg]; wave_without:OBSTACLE
///   wave_loss            of three gauges or more: what the incident wave loses of its height in one of its lengths [%]
/// They are judged by ladders. Call it after add_probes.
void add_regular_wave(Comparison& comparison);
/// The parts of it that speak of forces, of bodies and of a hull that is free in a stream, over the periods that are judged
/// (wave_forces.cpp, wave_responses.cpp, hull_in_waves.cpp, wave_transmission.cpp).
void add_wave_forces(Comparison& comparison, const WavePeriods& periods);
void add_wave_responses(Comparison& comparison, const WavePeriods& periods);
void add_hull_in_waves(Comparison& comparison, const WavePeriods& periods);
void add_wave_transmission(Comparison& comparison, const GaugeSides& sides, const WavePeriods& periods);

/// Of records that were given their calm twin (record/wave_twin.h), judged by grid studies: means over the whole
/// periods less the settled means of the same run without the wave,
///   added_resistance [N]; of a free hull added_trim [deg], added_rise [m]
void add_added_by_waves(Comparison& comparison, const CompareOptions& options);

/// How far a place lies along the way of a record's wave (its numbers wave_direction and, of an oblique one,
/// wave_across, cosine and sine of its angle to x) [m].
double along_wave(const RunRecord& record, double x, double y);
/// First harmonics of gauges of a record over a time [s], by places along the wave's way [m]; those with fewer samples than
/// `fewest`, or without a place, are left out.
struct GaugeHarmonics {
    std::vector<double> x;
    std::vector<std::complex<double>> amplitude;  ///< [m]
};
GaugeHarmonics harmonics_at(const RunRecord& record, const std::set<std::string>& gauges, double from, double to,
                            double omega, std::size_t fewest);
/// A exp(-i omega t) + mean, fitted to samples by least squares over their whole time.
std::complex<double> first_harmonic(std::span<const double> t, std::span<const double> values, double omega);
/// First harmonic A exp(-i omega t) of a series in each period [unit of the series]; none where it has too few samples.
using PeriodHarmonics = std::vector<std::optional<std::complex<double>>>;
template <class OfRow>
PeriodHarmonics harmonics_of_periods(const std::vector<double>& time, const WavePeriods& periods, OfRow of_row) {
    PeriodHarmonics found;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period;
        const WaveSamples s = samples_between(time, from, from + periods.period, of_row);
        found.emplace_back();
        if (static_cast<int>(s.t.size()) >= fewest_in_a_period)
            found.back() = first_harmonic(s.t, s.x, 2 * std::numbers::pi / periods.period);
    }
    return found;
}
/// By how much they are before a crest of the theory that passes x at k x / omega [deg]: the mean of -arg(A exp(-i k x)),
/// each taken round that of the sum. `k_x`: k x [rad].
MeanValue mean_lead(const PeriodHarmonics& harmonics, double k_x, const WavePeriods& periods);

/// Mean of a column over whole periods, of each of which a mean and three harmonics are fitted.
MeanValue mean_in_periods(const RunRecord& record, const std::string& table, const std::string& column,
                          const WavePeriods& periods);
/// The mean of that fit, which is not that of the samples where they are no whole number a period.
double mean_level(std::span<const double> t, std::span<const double> values, double omega);

}  // namespace tw
