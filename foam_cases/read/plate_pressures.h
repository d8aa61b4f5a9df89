#pragma once
#include <Eigen/SparseCore>
#include <filesystem>
#include <optional>
#include <string>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/hull_patch.h"
#include "record/run_record.h"
#include "structure/shell/shell.h"

namespace tw {

/// From pressures on the faces of a plate's closed surface to the net pressure on each of its elements, on the face out
/// of which the normal points:
///
///   p_e = sum_f p_f A_fe . n_e / A_e
///
/// A_fe is that part of the face's area vector, out of the plate, whose perpendicular meets the element: each face is
/// cut until its parts are a quarter of an element wide, so their sum is kept whatever the sizes of cells and elements.
/// Faces of the rim push along the plate and count for nothing.
///
/// `shown`: of each element's area, how much lies in the mesh: less than 1 of a strip that is wider than its slab.
Eigen::SparseMatrix<double> pressures_from_faces(const HullPatch& patch, const structure::Shell& shell,
                                                 double shown = 1);

/// Takes what the function object `plateSurface` has left of the rigid counterpart of an elastic plate into the record's
/// table `plate_pressure_table`: one row per time, one column per element.
class PlatePressures {
public:
    /// The plan must outlive it, and move an elastic plate.
    PlatePressures(const CasePlan& plan, std::filesystem::path case_folder);

    /// The times that the record does not hold yet and that lie before `limit` [s]. A surface that is not whole is left
    /// out.
    void read_before(double limit, RunRecord& record);

private:
    const CasePlan& plan_;
    std::filesystem::path post_;
    structure::Shell shell_;
    /// Of the plate's own axes, in which its faces stay where they are.
    std::optional<Eigen::SparseMatrix<double>> from_faces_;
};

}  // namespace tw
