#pragma once
#include <memory>

#include "sph_solver/backend/cuda/driver.h"
#include "sph_solver/levels/device_steps.h"
#include "sph_solver/sweeps/views.h"

namespace tw {

class Level;

/// A level whose steps are made by a graphics processor: water on particles of one size under constant gravity, with
/// walls at rest, whose pressure is linear in the density. In a step the host gets the loads of the groups at walls, the
/// extremes, and the few particles that a wall has to hold.
class LevelOnDevice : public DeviceSteps {
public:
    /// `level` must outlive this; its lists are made afterwards.
    LevelOnDevice(Level& level, std::shared_ptr<cuda::Device> device);
    ~LevelOnDevice() override;

    void bring_state_home() override;
    void bring_all_home() override;
    void bring_home(const std::vector<std::size_t>& particles) override;
    void note_changed_state() override { state_changed_ = true; }
    void forget() override { state_is_home_ = all_is_home_ = true; }
    void take_lists() override;
    void refresh(double drift) override;
    void first_sweep(double compress, double drift) override;
    void second_sweep(double t) override;
    Moved move(const Move& of_host) override;
    void put_back(const std::vector<std::size_t>& held) override;
    double bytes() const override;

private:
    struct Arrays;
    template <class Task>
    void start(const char* kernel, const Task& task, std::size_t count);
    template <class View>
    void sweep(const char* kernel, const View& view, const cuda::Array<Group>& groups);
    WaterView water() const;
    WallView walls() const;
    void take_state();
    void refresh_images(GradientPressureRecord* stress);
    void note_air();
    void fetch(std::vector<std::int32_t> particles);

    Level& level_;
    std::shared_ptr<cuda::Device> device_;
    std::unique_ptr<Arrays> on_;
    bool state_is_home_ = true, all_is_home_ = true, state_changed_ = false;
};

}  // namespace tw
