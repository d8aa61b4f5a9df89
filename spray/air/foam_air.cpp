#include "spray/air/foam_air.h"

#include <fmt/format.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/errors.h"
#include "spray/openfoam/foam_fields.h"

namespace tw::spray {

struct FoamAir::Field {
    Field(const std::filesystem::path& folder, double time)
        : fields(folder, time, FoamFields::At::points), u(fields.field("U", 3)) {
        locator->SetDataSet(&fields.grid());
        locator->BuildLocator();  // by one thread; it is only read from then on
    }
    FoamFields fields;
    vtkDataArray& u;
    vtkNew<vtkStaticCellLocator> locator;
    const std::uint64_t serial = ++fields_so_far;  ///< tells fields apart, also those at an address used before
    inline static std::atomic<std::uint64_t> fields_so_far{0};
};

namespace {

constexpr std::size_t most_corners = 8;  ///< of a cell, as polyhedra were cut up

/// The cell that a thread asked for last: a droplet's next place is often in it again, and to look there takes a
/// fraction of a search's time. It answers only well inside, where no other cell could have been found, and as it does
/// after a search, so that what was asked before does not show.
class LastCell {
public:
    using Weights = std::array<double, 64>;

    /// Takes over the cell that a search has left in `cell`, with the values at its corners.
    bool becomes(std::uint64_t serial, vtkDataArray& values) {
        serial_ = 0;
        const auto corners = static_cast<std::size_t>(cell->GetNumberOfPoints());
        if (corners > most_corners) return false;
        for (std::size_t k = 0; k < corners; ++k) {
            const auto id = static_cast<vtkIdType>(k);
            values.GetTuple(cell->GetPointId(id), u_[k].data());
            cell->GetPoints()->GetPoint(id, corner_[k].data());
        }
        cell->GetBounds(bounds_);
        is_box_ = cell->GetCellType() == VTK_HEXAHEDRON && is_parallelepiped();
        serial_ = serial;
        return true;
    }
    /// Weights of the corners where the cell of that field holds x, well inside.
    bool holds(std::uint64_t serial, const double x[3], Weights& weights) {
        if (serial_ != serial) return false;
        for (int k = 0; k < 3; ++k)
            if (!(x[k] >= bounds_[2 * k] && x[k] <= bounds_[2 * k + 1])) return false;
        if (is_box_) {
            weigh_box(x, weights);
        } else {
            double within[3], closest[3], distance = 0;
            int part = 0;
            if (cell->EvaluatePosition(x, closest, part, within, distance, weights.data()) != 1) return false;
        }
        return std::all_of(weights.begin(), weights.begin() + cell->GetNumberOfPoints(),
                           [](double w) { return w > 1e-7; });
    }
    /// Mean of the corners' values. `found`: the weights of a search.
    Vec3 at(const double x[3], Weights found) const {
        if (is_box_) weigh_box(x, found);
        Vec3 sum = Vec3::Zero();
        const auto corners = static_cast<std::size_t>(cell->GetNumberOfPoints());
        for (std::size_t k = 0; k < corners; ++k) sum += found[k] * u_[k];
        return sum;
    }
    void forget() { serial_ = 0; }
    vtkNew<vtkGenericCell> cell;

private:
    /// Corners in VTK's order: round the bottom, then round the top.
    bool is_parallelepiped() {
        const Vec3 a = corner_[1] - corner_[0], b = corner_[3] - corner_[0], c = corner_[4] - corner_[0];
        const double slack = 1e-9 * (a.norm() + b.norm() + c.norm());
        const auto off = [&](std::size_t k, const Vec3& from_first) {
            return (corner_[k] - corner_[0] - from_first).norm() > slack;
        };
        if (off(2, a + b) || off(5, a + c) || off(6, a + b + c) || off(7, b + c)) return false;
        Eigen::Matrix3d edges;
        edges << a, b, c;
        to_shares_ = edges.inverse();
        return to_shares_.allFinite();
    }
    void weigh_box(const double x[3], Weights& w) const {
        const Vec3 s = to_shares_ * (Vec3(x[0], x[1], x[2]) - corner_[0]), t = Vec3::Ones() - s;
        w[0] = t.x() * t.y() * t.z(), w[1] = s.x() * t.y() * t.z();
        w[2] = s.x() * s.y() * t.z(), w[3] = t.x() * s.y() * t.z();
        w[4] = t.x() * t.y() * s.z(), w[5] = s.x() * t.y() * s.z();
        w[6] = s.x() * s.y() * s.z(), w[7] = t.x() * s.y() * s.z();
    }

    std::uint64_t serial_ = 0;  ///< of its field; 0: none yet
    double bounds_[6] = {};
    std::array<Vec3, most_corners> u_, corner_;
    bool is_box_ = false;  ///< of parallel faces: shares along its edges are linear in the place
    Eigen::Matrix3d to_shares_;
};

/// OpenFOAM's names of times carry at least six digits.
bool same_time(double a, double b) { return std::abs(a - b) <= 1e-5 * std::max(std::abs(a), std::abs(b)); }

double written_time(const std::filesystem::path& folder, std::optional<double> asked) {
    const std::vector<FoamTime> times = foam_times(folder);
    if (times.empty()) throw InputError(folder.string() + ": no written time there; expected at least 0");
    if (!asked) return times.back().time;
    const auto found = std::ranges::find_if(times, [&](const FoamTime& t) { return same_time(t.time, *asked); });
    if (found == times.end())
        throw InputError(fmt::format("{}: no time {:g} s is written; it has {} from {:g} to {:g} s", folder.string(),
                                     *asked, times.size(), times.front().time, times.back().time));
    return found->time;
}

}  // namespace

FoamAir::FoamAir(const std::filesystem::path& run, std::optional<double> time, const AirState& state) : state_(state) {
    check_air(state);
    const std::filesystem::path folder = foam_case(run);
    const double at = written_time(folder, time);
    field_ = std::make_unique<const Field>(folder, at);
    for (vtkIdType i = 0; i < field_->u.GetNumberOfTuples(); ++i) {
        double u[3];
        field_->u.GetTuple(i, u);
        if (!std::isfinite(u[0] + u[1] + u[2]))
            throw InputError(fmt::format("{}: field U is not finite at {:g} s; expected the state of a sound run",
                                         folder.string(), at));
    }
}

FoamAir::~FoamAir() = default;

bool FoamAir::at(const Vec3& place, AirState& state) const {
    static thread_local LastCell last;
    const double x[3] = {place.x(), place.y(), place.z()};
    LastCell::Weights weights;
    if (!last.holds(field_->serial, x, weights)) {
        double searched[3] = {x[0], x[1], x[2]}, within[3];
        if (field_->locator->FindCell(searched, 0, last.cell, within, weights.data()) < 0 ||
            !last.becomes(field_->serial, field_->u)) {
            last.forget();
            return false;
        }
    }
    state = state_;
    state.velocity = last.at(x, weights);
    return true;
}

}  // namespace tw::spray
