#include "foam_cases/read/solver_log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "foam_cases/read/number_rows.h"

namespace tw {
namespace {

constexpr std::size_t kept_lines = 200;
constexpr int fatal_block = 14;  // lines that OpenFOAM's error messages take at most before the stack trace

/// The number behind `label`, wherever that stands in the line.
std::optional<double> number_after(std::string_view line, std::string_view label) {
    const std::size_t at = line.find(label);
    if (at == std::string_view::npos) return std::nullopt;
    line.remove_prefix(at + label.size());
    while (!line.empty() && line[0] == ' ') line.remove_prefix(1);
    if (line.rfind("nan", 0) == 0 || line.rfind("-nan", 0) == 0) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    if (std::from_chars(line.data(), line.data() + line.size(), value).ec != std::errc{}) return std::nullopt;
    return value;
}

}  // namespace

void SolverLog::feed(std::string_view text) {
    for (;;) {
        const std::size_t end = text.find('\n');
        partial_.append(text.substr(0, end));
        if (end == std::string_view::npos) return;
        line(partial_);
        partial_.clear();
        text.remove_prefix(end + 1);
    }
}

void SolverLog::line(std::string_view text) {
    recent_.emplace_back(text);
    if (recent_.size() > 2 * kept_lines) recent_.erase(recent_.begin(), recent_.begin() + kept_lines);
    if (fatal_lines_ > 0) {
        --fatal_lines_;
        if (text.rfind("FOAM ", 0) == 0)
            fatal_lines_ = 0;  // "FOAM exiting", "FOAM aborting"
        else if (!text.empty())
            fatal_ += "\n" + std::string(text);
    }
    if (text.find("--> FOAM FATAL") != std::string_view::npos && fatal_.empty()) {
        fatal_ = text;
        fatal_lines_ = fatal_block;
    } else if (const auto start = number_after(text, "Create mesh for time = ")) {
        const double gone_on_from = *start * (1 + time_name_precision);
        std::erase_if(steps_, [&](const Step& s) { return s.time > gone_on_from; });
    } else if (text.rfind("Time = ", 0) == 0 && text.find("accelerations") == std::string_view::npos) {
        // not the header's "Time   : 12:00:00", nor what a tank that moves says in a step; openfoam.org writes "0.1s"
        const auto time = number_after(text, "Time = ");
        if (!time) return;
        while (!steps_.empty() && steps_.back().time >= *time) steps_.pop_back();
        next_.time = *time;
        next_.water = std::numeric_limits<double>::quiet_NaN();
        steps_.push_back(next_);
        ended_ = false;
    } else if (text.rfind("deltaT = ", 0) == 0) {
        next_.step = number_after(text, "deltaT = ").value_or(next_.step);
    } else if (text.rfind("Courant Number", 0) == 0) {
        next_.courant = number_after(text, "max:").value_or(next_.courant);
    } else if (text.rfind("Interface Courant Number", 0) == 0) {
        next_.alpha_courant = number_after(text, "max:").value_or(next_.alpha_courant);
    } else if (text.rfind("Phase-1 volume fraction", 0) == 0) {
        if (steps_.empty()) return;
        Step& step = steps_.back();
        step.water = number_after(text, "fraction =").value_or(step.water);
        step.least = number_after(text, "Min(alpha.water) =").value_or(step.least);
        step.most = number_after(text, "Max(alpha.water) =").value_or(step.most);
    } else if (text.rfind("time step continuity errors", 0) == 0) {
        if (steps_.empty()) return;
        steps_.back().continuity = number_after(text, "sum local =").value_or(steps_.back().continuity);
    } else if (text.rfind("ExecutionTime", 0) == 0) {
        if (steps_.empty()) return;
        steps_.back().cpu = number_after(text, "ExecutionTime =").value_or(steps_.back().cpu);
        if (bodies_.size() > 1) steps_.back().bodies = bodies_;
    } else if (text == "End") {
        ended_ = true;
    } else {
        body_line(text);
    }
}

void SolverLog::turn_to(std::string_view body) {
    body_ = 0;
    while (body_ < bodies_.size() && bodies_[body_].name != body) ++body_;
    if (body_ == bodies_.size()) bodies_.push_back({.name = std::string(body)});
}

/// What sixDoFRigidBodyMotion and, of several bodies, rigidBodyMotion report; the latter names each body, reports its
/// centre of mass as the one that it turns about, and writes the orientation as that of the earth seen from the body.
void SolverLog::body_line(std::string_view text) {
    constexpr std::string_view several = "Rigid-body motion of the ";
    if (text == "6-DoF rigid body motion") return turn_to("");
    if (text.starts_with(several)) return turn_to(text.substr(several.size()));
    const auto numbers = [&](std::string_view label, std::size_t count) {
        const std::size_t at = text.find(label);
        std::vector<double> n = at == std::string_view::npos ? std::vector<double>{} : numbers_in(text.substr(at));
        return n.size() == count && body_ < bodies_.size() ? n : std::vector<double>{};
    };
    const bool named = body_ < bodies_.size() && !bodies_[body_].name.empty();
    if (const auto n = numbers(named ? "Centre of rotation: " : "Centre of mass: ", 3); !n.empty())
        bodies_[body_].centre = Vec3(n.data());
    else if (const auto v = numbers("Linear velocity: ", 3); !v.empty())
        bodies_[body_].velocity = Vec3(v.data());
    else if (const auto w = numbers("Angular velocity: ", 3); !w.empty())
        bodies_[body_].spin = Vec3(w.data());
    else if (const auto r = numbers("Orientation: ", 9); !r.empty()) {
        const Eigen::Matrix3d columns(r.data());  // Eigen reads columns first, OpenFOAM writes rows
        bodies_[body_].attitude = named ? columns : columns.transpose();
    }
}

const SolverLog::Step* SolverLog::at(double time) const {
    const double tolerance = 1e-9 * (1 + std::abs(time));
    auto after = std::upper_bound(steps_.begin(), steps_.end(), time + tolerance,
                                  [](double t, const Step& s) { return t < s.time; });
    return after == steps_.begin() ? nullptr : &*std::prev(after);
}

std::string SolverLog::tail(std::size_t lines) const {
    std::string out;
    for (std::size_t i = recent_.size() > lines ? recent_.size() - lines : 0; i < recent_.size(); ++i)
        out += recent_[i] + "\n";
    return out;
}

}  // namespace tw
