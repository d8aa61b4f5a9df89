#pragma once
#include <cstddef>

#include "sph_solver/device/kernel_of.h"
#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/pack_state.h"

namespace tw {

// Steps in stages (explicit Runge-Kutta), of each particle by itself.

/// Its state at the step's begin.
struct StageStart {
    double x, y, z;       ///< [m]
    float u, v, w, drho;  ///< [m/s], [kg/m3]
};
/// Velocity and rates, weighted over the stages.
struct StageMean {
    double u, v, w, ax, ay, az, drho;  ///< [m/s], [m/s2], [kg/m3/s]
};

struct NoteCompression {
    const PackedRate* rate;
    float* compression;  ///< -rho div u [kg/m3/s]

    void operator()(std::size_t i) const { compression[i] = rate[i].drho; }
};

/// From the step's begin for the time `since`, with the velocities and rates found last.
struct GoToStage {
    StateView p;
    const Kind* kind;
    const StageStart* start;
    const PackedRate* rate;
    double since;                  ///< [s]
    double stream, stream_before;  ///< its velocity now, and at the step's begin [m/s]
    double outlet_share;           ///< of Move [-]
    bool inlet_has_wave;           ///< of Move; then they keep their velocities over the step

    void operator()(std::size_t i) const {
        const StageStart& from = start[i];
        const PackedRate& r = rate[i];
        p.x[i] = from.x + since * static_cast<double>(p.u[i]);
        p.y[i] = from.y + since * static_cast<double>(p.v[i]);
        p.z[i] = from.z + since * static_cast<double>(p.w[i]);
        switch (kind[i]) {
            case Kind::fluid:
                p.u[i] = static_cast<float>(static_cast<double>(from.u) + since * static_cast<double>(r.ax));
                p.v[i] = static_cast<float>(static_cast<double>(from.v) + since * static_cast<double>(r.ay));
                p.w[i] = static_cast<float>(static_cast<double>(from.w) + since * static_cast<double>(r.az));
                p.drho[i] = static_cast<float>(static_cast<double>(from.drho) + since * static_cast<double>(r.drho));
                break;
            case Kind::inlet:
                if (!inlet_has_wave) p.u[i] = static_cast<float>(stream);
                break;
            case Kind::outlet:
                p.u[i] = static_cast<float>(static_cast<double>(from.u) + outlet_share * (stream - stream_before));
                break;
            case Kind::buffer:
            case Kind::overlap:
            case Kind::slave: break;  // levels of particle size take steps of one evaluation
        }
    }
};

/// A stage's velocities and rates, with its weight; the first one notes where the step begins.
struct AddStage {
    StateView p;
    PackedRate* rate;
    StageStart* start;
    StageMean* mean;
    const float* compression;  ///< -rho div u of this stage [kg/m3/s]
    float* diffusion;          ///< D of the first stage, which serves all [kg/m3/s]; null: each has its own
    double weight;             ///< of the stage [-]
    bool first;

    void operator()(std::size_t i) const {
        PackedRate& r = rate[i];
        if (first) {
            start[i] = {p.x[i], p.y[i], p.z[i], p.u[i], p.v[i], p.w[i], p.drho[i]};
            if (diffusion) diffusion[i] = r.drho;
        }
        r.drho = compression[i] + (diffusion ? diffusion[i] : r.drho);
        StageMean& m = mean[i];
        m.u += weight * static_cast<double>(p.u[i]);
        m.v += weight * static_cast<double>(p.v[i]);
        m.w += weight * static_cast<double>(p.w[i]);
        m.ax += weight * static_cast<double>(r.ax);
        m.ay += weight * static_cast<double>(r.ay);
        m.az += weight * static_cast<double>(r.az);
        m.drho += weight * static_cast<double>(r.drho);
    }
};

/// Back to the step's begin, with the mean rates.
struct EndStages {
    StateView p;
    PackedRate* rate;
    const StageStart* start;
    const StageMean* mean;

    void operator()(std::size_t i) const {
        const StageStart& from = start[i];
        const StageMean& m = mean[i];
        p.x[i] = from.x, p.y[i] = from.y, p.z[i] = from.z;
        p.u[i] = from.u, p.v[i] = from.v, p.w[i] = from.w, p.drho[i] = from.drho;
        rate[i] = {static_cast<float>(m.ax), static_cast<float>(m.ay), static_cast<float>(m.az),
                   static_cast<float>(m.drho)};
    }
};

#define TW_STAGE_TASKS(task)                                                                                \
    task(tw_note_compression, NoteCompression) task(tw_go_to_stage, GoToStage) task(tw_add_stage, AddStage) \
        task(tw_end_stages, EndStages)
TW_STAGE_TASKS(TW_KERNEL_OF)

}  // namespace tw
