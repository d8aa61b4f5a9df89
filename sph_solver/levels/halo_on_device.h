#pragma once
#include <initializer_list>

#include "sph_solver/cuda/driver.h"
#include "sph_solver/cuda/messages.h"
#include "sph_solver/parallel/halo.h"

namespace tw {

/// Of each element of an array of the device: all of it, or what stands from one of its members on, so many bytes.
template <class T>
cuda::PartOfEach of_each(T* array) {
    return {reinterpret_cast<std::byte*>(array), sizeof(T), sizeof(T)};
}
template <class T>
cuda::PartOfEach of_each(T* array, std::size_t from, std::size_t bytes) {
    return {reinterpret_cast<std::byte*>(array) + from, sizeof(T), static_cast<std::int32_t>(bytes)};
}

/// The halo exchange of things on a device: it packs what its rank owns into one message, which goes by the host, and
/// unpacks what comes. Nothing but this is copied.
class HaloOnDevice {
public:
    explicit HaloOnDevice(cuda::Device& device)
        : device_(&device), sent_(device), received_(device), out_(device), in_(device) {}
    /// Whom it exchanges with from now on; `halo` must outlive it.
    void set(const Halo& halo);
    bool is(const Halo& halo) const { return halo_ == &halo; }
    void exchange(std::initializer_list<cuda::PartOfEach> parts);
    std::size_t bytes() const { return sent_.bytes() + received_.bytes() + out_.bytes() + in_.bytes(); }

private:
    cuda::Device* device_;
    const Halo* halo_ = nullptr;
    cuda::Array<int> sent_, received_;
    cuda::Array<std::byte> out_, in_;
};

}  // namespace tw
