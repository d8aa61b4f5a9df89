#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "sph_solver/device/kernel_of.h"
#include "sph_solver/pair_loops/clusters.h"

namespace tw {

class Halo;

/// Memory of a device for an array.
class RoomOnDevice {
public:
    virtual ~RoomOnDevice() = default;
    /// Gives where it is. What it holds is lost.
    virtual void* resize(std::size_t bytes) = 0;
    virtual void set_zero() = 0;
    virtual void download(void* to, std::size_t bytes) const = 0;
    virtual std::size_t bytes() const = 0;
};

/// A device that runs loops of for_particles.h in place of this process. Loops come as their bodies or views, whose
/// pointers are the device's; their types say which kernel it is.
class DeviceLoops {
public:
    virtual ~DeviceLoops() = default;
    virtual void each(DeviceKernel body, std::size_t count) = 0;
    virtual double largest(DeviceKernel value, std::size_t count) = 0;  ///< 0 or more
    virtual void pairs(DeviceKernel view, std::span<const Cluster> clusters) = 0;
    /// The pair loop of a view over those of the clusters that a condition chooses, which get to `chosen`.
    virtual void pairs_where(DeviceKernel condition, std::span<const Cluster> clusters, Cluster* chosen,
                             DeviceKernel view) = 0;
    virtual std::unique_ptr<RoomOnDevice> make_room() = 0;
    /// Halo::exchange of an array of the device, of elements of so many bytes.
    virtual void exchange(const Halo& halo, void* values, std::size_t bytes) = 0;
};

/// An array where the loops run: here, or on a device.
template <class T>
class LoopArray {
public:
    /// Gives where it is. What it holds is lost on a device; null: here.
    T* resize(DeviceLoops* device, std::size_t n) {
        size_ = n;
        if (!device) {
            here_.resize(n);
            return at_ = here_.data();
        }
        if (!there_) there_ = device->make_room();
        return at_ = static_cast<T*>(there_->resize(n * sizeof(T)));
    }
    T* zeros(DeviceLoops* device, std::size_t n) {
        if (!device) here_.clear();
        T* const at = resize(device, n);
        if (there_) there_->set_zero();
        return at;
    }
    T* data() const { return at_; }  ///< where the loops run; null: it was never used
    /// A copy on the host of what it holds.
    const std::vector<T>& copy_to_host() {
        if (there_) {
            here_.resize(size_);
            there_->download(here_.data(), size_ * sizeof(T));
        }
        return here_;
    }
    const std::vector<T>& on_host() const { return here_; }  ///< as copied last
    std::size_t bytes() const { return here_.capacity() * sizeof(T) + (there_ ? there_->bytes() : 0); }

private:
    std::vector<T> here_;
    std::unique_ptr<RoomOnDevice> there_;
    T* at_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace tw
