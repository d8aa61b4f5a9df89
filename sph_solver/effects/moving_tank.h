#pragma once
#include <memory>

namespace tw {

class Effect;

/// In the axes of a tank that moves (motion/moving_frame.h) the water feels, beside gravity as it is without motion,
///
///   du/dt += f(x, u, t) - g
///
/// The walls' part, a pressure that holds the water against f, is with the mirror images (ghosts/) and with the dummies
/// of obstacles (bodies/walls.h), which find f in the surroundings.
struct MovingTank {};
std::unique_ptr<Effect> make_effect(const MovingTank&);

}  // namespace tw
