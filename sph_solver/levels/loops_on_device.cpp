#include "sph_solver/levels/loops_on_device.h"

#include <algorithm>

#include "sph_solver/device/launch.h"

namespace tw {

namespace {

class Room : public RoomOnDevice {
public:
    explicit Room(std::shared_ptr<cuda::Device> device) : device_(std::move(device)), of_(*device_) {}
    void* resize(std::size_t bytes) override {
        of_.resize(bytes);
        return of_.data();
    }
    void set_zero() override { of_.set_zero(); }
    void download(void* to, std::size_t bytes) const override { of_.download({static_cast<std::byte*>(to), bytes}); }
    std::size_t bytes() const override { return of_.bytes(); }

private:
    std::shared_ptr<cuda::Device> device_;
    cuda::Array<std::byte> of_;
};

}  // namespace

void LoopsOnDevice::each(DeviceKernel body, std::size_t count) {
    void* arguments[] = {body.argument(), &count};
    device_->launch(body.name(), count, arguments);
}

double LoopsOnDevice::largest(DeviceKernel value, std::size_t count) {
    parts_.resize((count + cuda::threads_in_block - 1) / cuda::threads_in_block);
    double* parts = parts_.data();
    void* arguments[] = {value.argument(), &parts, &count};
    device_->launch(value.name(), count, arguments);
    std::vector<double> on_host(parts_.size());
    parts_.download(on_host);
    return on_host.empty() ? 0 : *std::ranges::max_element(on_host);
}

void LoopsOnDevice::pairs(DeviceKernel view, std::span<const Cluster> clusters) {
    const Cluster* first = clusters.data();
    int count = static_cast<int>(clusters.size());
    void* arguments[] = {view.argument(), &first, &count};
    device_->launch(view.name(), clusters.size() * cuda::warp, arguments);
}

/// How many clusters were chosen the device alone knows: nobody waits for it.
void LoopsOnDevice::pairs_where(DeviceKernel condition, std::span<const Cluster> clusters, Cluster* chosen,
                                DeviceKernel view) {
    count_.resize(1);
    count_.set_zero();
    const Cluster* of = clusters.data();
    int* count = count_.data();
    std::size_t n = clusters.size();
    void* to_choose[] = {condition.argument(), &of, &chosen, &count, &n};
    device_->launch(condition.name(), n, to_choose);
    const Cluster* first = chosen;
    void* arguments[] = {view.argument(), &first, &count};
    device_->launch(view.name(), n * cuda::warp, arguments);
}

void LoopsOnDevice::exchange(const Halo& halo, void* values, std::size_t bytes) {
    HaloOnDevice& own = halo_.is(halo) ? halo_ : dummies_halo_;
    own.exchange(
        {{static_cast<std::byte*>(values), static_cast<std::int32_t>(bytes), static_cast<std::int32_t>(bytes)}});
}

std::unique_ptr<RoomOnDevice> LoopsOnDevice::make_room() { return std::make_unique<Room>(device_); }

}  // namespace tw
