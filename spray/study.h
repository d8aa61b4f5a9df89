#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "spray/air/air.h"
#include "spray/extract/extract.h"
#include "spray/extract/read_frames.h"
#include "spray/flight/fly.h"
#include "spray/flight/reach.h"
#include "spray/load/estimate.h"
#include "spray/load/repeats.h"
#include "spray/load/small_face.h"

namespace tw::spray {

/// Where droplets come from: exactly one of the four.
struct Source {
    std::filesystem::path sph;      ///< RUN/sph with its snapshots
    std::filesystem::path taken;    ///< RUN/sph, whose gate took the water out of the run
    std::filesystem::path fvm;      ///< RUN/fvm, or an OpenFOAM case
    std::vector<Droplet> droplets;  ///< given as a table
    FrameRange range;
    std::optional<bool> mirror;  ///< add the other side of a half model; nothing: as the run's record says
    double least_share = 0.05;   ///< of water in a cell, below which it is left out [-]
};

/// A surface to hit, by name.
struct TargetSurface {
    std::string name;
    Surface surface;
};

/// A sensor and how its load is taken.
struct SensorStudy {
    Sensor sensor;
    Window window;                                              ///< edge and length; its time is found
    std::vector<double> edges{1e-3, 2e-3, 5e-3, 0.01, 0.02};    ///< for the convergence [m]; 1 to 400 mm2
    std::vector<double> lengths{1e-4, 3e-4, 1e-3, 3e-3, 0.01};  ///< for the convergence [s]
    LoadOptions load;
    int draws = 400;               ///< of the bootstrap
    double face = 1e-3;            ///< edge of what really measures [m]
    std::vector<double> measured;  ///< repeats to compare with [Pa]; empty: none
};

/// What `twinwake spray` computes.
struct SprayStudy {
    std::string title;
    Source source;
    ExtractOptions extraction;
    std::shared_ptr<const Air> air;
    bool refuse_left_air = true;  ///< a droplet that leaves the air field ends the study; false: its flight only
    double duration = 1;          ///< of flight, after the last droplet was released [s]
    FlightOptions flight;         ///< end_time, water_density and gravity are filled in
    std::vector<TargetSurface> targets;
    std::optional<SensorStudy> sensor;
    std::string against_name;  ///< another spray, whose statistics stand beside this one's; empty: none
    std::vector<Droplet> against;
};

/// Highest way and its middle in one slice of the room.
struct EnvelopeSlice {
    double at = 0;       ///< x or y of its middle [m]
    double highest = 0;  ///< z [m]
    double mean = 0;     ///< z, by volume [m]
};

/// Load of the sensor during one window.
struct WindowLoad {
    Window window;
    Estimate estimate;
    Intervals droplets;  ///< bootstrap over droplets alone
};

/// What came of it.
struct SprayResult {
    Extraction extraction;
    std::vector<Droplet> droplets;
    std::vector<Landing> landings;
    double left_out = 0;                    ///< water of cells below the least share, over all frames [m3]
    std::vector<std::string> target_names;  ///< "sensor" the last, where there is one
    std::vector<Reach> reaches;             ///< what the middle of each of them asks for
    Budget back, landed, away;              ///< droplets as they fell back, met a surface, or flew on
    std::vector<EnvelopeSlice> side, front;
    // of the sensor
    std::vector<Arrival> arrivals;
    std::vector<WindowLoad> windows;     ///< side by side in time, over all arrivals
    std::optional<WindowLoad> peak;      ///< the window with the largest average
    std::optional<WindowLoad> anywhere;  ///< the same over all windows side by side on the sensor
    FaceHits face;                       ///< of all arrivals
    std::optional<Repeats> measured;
    Intervals over_windows;                      ///< at that time, over droplets and windows of the sensor
    std::size_t tiles = 0;                       ///< how many those are
    std::vector<WindowLoad> by_area, by_length;  ///< round that time
    LoadCurve curve;                             ///< over all arrivals
};

/// How the study's droplets fly, but for when that ends.
FlightOptions flight_of(const SprayStudy& study);

/// Extracts, flies and loads. Throws InputError: bad options, nothing to read, a window larger than its sensor, droplets
/// that leave the air field.
SprayResult run_spray(const SprayStudy& study);

}  // namespace tw::spray
