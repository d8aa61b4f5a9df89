#include "spray/air/foam_air.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <cmath>
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
};

namespace {

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
    static thread_local vtkNew<vtkGenericCell> cell;
    double x[3] = {place.x(), place.y(), place.z()}, within[3];
    std::array<double, 64> weights;  // of the corners of a cell: at most eight, as polyhedra were cut up
    if (field_->locator->FindCell(x, 0, cell, within, weights.data()) < 0) return false;
    state = state_;
    state.velocity.setZero();
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k) {
        double u[3];
        field_->u.GetTuple(cell->GetPointId(k), u);
        state.velocity += weights[static_cast<std::size_t>(k)] * Vec3(u[0], u[1], u[2]);
    }
    return true;
}

}  // namespace tw::spray
