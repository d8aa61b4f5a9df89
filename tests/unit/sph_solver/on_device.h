#pragma once
// Steps that a device makes, through a driver that has none (tests/fake_cuda): all that the host does for a real one,
// with kernels that compute what the variant device_emulated does, to the last bit. Memory that nobody wrote is not a
// number there, and every access beyond an array ends the program.
//
// With TWINWAKE_TEST_LIBCUDA=libcuda.so.1 and TWINWAKE_STRICT_KERNELS=1 in the environment the same is asked of a real
// one (tools/gpu_evidence.sh).
#include <gtest/gtest.h>

#include <cstdlib>

#include "meshes/generate.h"
#include "sph_solver/levels/on_device.h"
#include "sph_solver/simulation.h"

namespace tw {

class OnDevice : public ::testing::Test {
protected:
    void SetUp() override { setenv("TWINWAKE_LIBCUDA", real() ? real() : TWINWAKE_FAKE_CUDA, 1); }
    static const char* real() { return std::getenv("TWINWAKE_TEST_LIBCUDA"); }
    void TearDown() override { pretend(""), unsetenv("TWINWAKE_LIBCUDA"); }
    /// See fake_cuda.cpp.
    static void pretend(const char* what) { setenv("FAKE_CUDA", what, 1); }
};

/// A column of water that falls against a block on the floor of its tank.
inline SimulationSetup dam_break() {
    SimulationSetup s;
    s.dp = 0.05;
    s.state_equation.c0 = 30;
    s.domain = {Vec3(0, 0, 0), Vec3(1, 0.3, 1)};
    s.mirrors.on = {{{true, true}, {true, true}, {true, false}}};
    s.bodies = {box_surface({Vec3(0.6, -0.4, -0.3), Vec3(0.8, 0.7, 0.15)})};
    s.threads = 1;
    return s;
}
inline Fluid water_of(const SimulationSetup& s) {
    return fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}});
}

inline const Passes& emulated() { return passes("device_emulated"); }
/// All its levels; the device they share.
inline std::shared_ptr<cuda::Device> put_on_device(Simulation& s) {
    const auto device = cuda::Device::open();
    for (std::size_t k = 0; k < s.levels().size(); ++k) {
        s.level(k).leave_steps_to([&](ParticleSystem& system, RankShare& share) {
            return std::make_unique<LevelOnDevice>(system, share, device);
        });
    }
    return device;
}

inline ::testing::AssertionResult same_bits(const Particles& a, const Particles& b) {
    if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " particles against " << b.size();
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a.id[i] != b.id[i] || a.kind[i] != b.kind[i] || a.x[i] != b.x[i] || a.y[i] != b.y[i] || a.z[i] != b.z[i] ||
            a.u[i] != b.u[i] || a.v[i] != b.v[i] || a.w[i] != b.w[i] || a.drho[i] != b.drho[i])
            return ::testing::AssertionFailure() << "particle " << i << " differs";
    return ::testing::AssertionSuccess();
}

}  // namespace tw
