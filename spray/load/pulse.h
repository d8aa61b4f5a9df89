#pragma once

namespace tw::spray {

/// How a droplet's force rises and falls: g(x) over the pulse's duration, largest value 1.
enum class PulseShape {
    /// g(x) = c sqrt(x) (1 - x)^4, x = t / duration, largest at x = 1/9. It rises with the root of time, as the early
    /// impact of a sphere does (Philippi, Lagree & Antkowiak 2016, arXiv:1504.05847), and its duration follows
    /// from peak and impulse: 2.03 ms for the study's droplet of 2.7 mm at 2.67 m/s, whose measured pulse took 2 ms.
    root,
    /// The study's polynomial (its Eq. 26) over its largest value, for times up to 0.6 ms only: its printed coefficients
    /// carry no further (0.003 N of 0.044 N lost to rounding there, 0.031 N at 1 ms, 2.5 N at 2 ms). Force 0 after that;
    /// the peak is right, the impulse is not.
    study
};

/// The force of one droplet on a wall in time.
class Pulse {
public:
    /// `peak` [N] and `impulse` [N s], above 0.
    Pulse(PulseShape shape, double peak, double impulse);
    double duration() const { return duration_; }  ///< [s]
    double force(double t) const;                  ///< [N], t from the first touch; 0 before and after
    double impulse_until(double t) const;          ///< integral of the force from the first touch to t [N s]

private:
    PulseShape shape_;
    double peak_, duration_;
};

/// The study's Eq. 26 as printed [N]; t from 0 to 6e-4 s.
double study_polynomial(double t);

}  // namespace tw::spray
