#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "scene/scene.h"

namespace tw::test {

/// One judged number of a run: how far it is from the truth, and how far it may be.
struct Row {
    std::string quantity, unit;
    double value = 0;     ///< signed deviation from the exact or measured value
    double limit = 0;     ///< largest permitted |value|
    bool passes() const;  ///< NaN fails
};

// Each judge takes any method's record of the scene. `from`: means are taken over the times from there on [s].

/// Water at rest: largest excursion of the surface over the whole run [dp], error of the mean pressure at every probe
/// [% of the floor's pressure], particles lost.
std::vector<Row> judge_still_water(const Scene& scene, const RunRecord& record, double from);

/// A hull wholly under still water: mean force against rho g V by every measure the record holds [%].
std::vector<Row> judge_buoyancy(const Scene& scene, const RunRecord& record, double from);

/// A stream with nothing in it: mean surface at every height probe [dp], drift of the mass [%], particles lost.
std::vector<Row> judge_channel(const Scene& scene, const RunRecord& record, double from);

/// Front of a collapsing column (height 2 a) against the boundary elements of tests/data/dambreak_front_bem.csv, without
/// friction as the run: mean and largest difference [%] over 1 <= t sqrt(2 g / a), until the front nears the wall.
std::vector<Row> judge_dam_break_front(const Scene& scene, const RunRecord& record, const std::filesystem::path& exact);

/// The same against every series of tests/data/dambreak_front_position.csv that is used as a witness. The time at which
/// the measured water was free is not known: each series is moved by the time that fits best, which is a row of its own
/// [-, in t sqrt(2 g / a)]; then the speeds are compared, not the start.
std::vector<Row> judge_measured_front(const Scene& scene, const RunRecord& record,
                                      const std::filesystem::path& measured);

/// A wedge dropped on water: its speed against tests/data/wedge_drop_momentum.csv, the momentum of its mass with that of
/// the water in the similarity solution, from the time on at which its keel meets the water [%].
std::vector<Row> judge_wedge_drop(const Scene& scene, const RunRecord& record, const std::filesystem::path& exact);

/// SPHERIC test 2: water heights at the four gauges [% of the still column] and pressures at the box [% of the largest
/// measured], root mean square over the common time; arrival of the water at the box [s].
std::vector<Row> judge_spheric2(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured);

/// Cylinders entering water in two dimensions: how far the body has gone down at each time of
/// tests/data/cylinder_2d_entry.csv for its density, measured and by a boundary element method [%].
std::vector<Row> judge_entry(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured);

/// Sloshing: elevation at the first height probe from 8.5 to 11 periods of the motion against the shallow-water equations
/// (tests/data/sloshing_shallow_water.csv) and, second, against tests/data/sloshing_bouscasse_2013.csv, whose zero is 5 mm
/// too high: crest and trough [% of the crest], the times at which the front rises through half of the depth [periods],
/// and the root mean square against the measurement.
std::vector<Row> judge_sloshing(const Scene& scene, const RunRecord& record, const std::filesystem::path& shallow_water,
                                const std::filesystem::path& measured);

/// Bodies of Qiu et al. 2017 in a tank: height of the centre over the floor at the times of tests/data/cubes_in_tank.csv
/// [mm from the measured one], of the case "falling" (heavier than water) or "floating", which
/// starts at the measurement's first crest.
std::vector<Row> judge_cubes(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured);

/// A body that floats in waves (the scene's second one): wave at the first height probe and heave, from crest to trough,
/// range of the pitch and drift in surge, over the last three periods of the piston (the scene's first body), against the
/// same of all whole periods of tests/data/box_in_waves.csv of this wave height.
std::vector<Row> judge_box_in_waves(const Scene& scene, const RunRecord& record, const std::filesystem::path& measured);

}  // namespace tw::test
