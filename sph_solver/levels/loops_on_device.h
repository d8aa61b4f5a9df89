#pragma once
#include <memory>

#include "sph_solver/backend/device_loops.h"
#include "sph_solver/cuda/driver.h"
#include "sph_solver/levels/halo_on_device.h"

namespace tw {

/// Loops on a graphics processor.
class LoopsOnDevice : public DeviceLoops {
public:
    explicit LoopsOnDevice(std::shared_ptr<cuda::Device> device)
        : device_(std::move(device)), parts_(*device_), count_(*device_), halo_(*device_), dummies_halo_(*device_) {}
    void each(DeviceKernel body, std::size_t count) override;
    double largest(DeviceKernel value, std::size_t count) override;
    void pairs(DeviceKernel view, std::span<const Cluster> clusters) override;
    void pairs_where(DeviceKernel condition, std::span<const Cluster> clusters, Cluster* chosen,
                     DeviceKernel view) override;
    std::unique_ptr<RoomOnDevice> make_room() override;
    void exchange(const Halo& halo, void* values, std::size_t bytes) override;
    /// Of the particles and of the dummies, from now on.
    void set_halos(const Halo& of_particles, const Halo& of_dummies) {
        halo_.set(of_particles), dummies_halo_.set(of_dummies);
    }
    HaloOnDevice& halo() { return halo_; }
    HaloOnDevice& dummies_halo() { return dummies_halo_; }
    std::size_t bytes() const { return parts_.bytes() + count_.bytes() + halo_.bytes() + dummies_halo_.bytes(); }

private:
    std::shared_ptr<cuda::Device> device_;
    cuda::Array<double> parts_;
    cuda::Array<int> count_;  ///< of chosen clusters
    HaloOnDevice halo_, dummies_halo_;
};

}  // namespace tw
