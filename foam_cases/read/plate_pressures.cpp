#include "foam_cases/read/plate_pressures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "foam_cases/one_way.h"
#include "foam_cases/read/body_rows.h"
#include "foam_cases/read/number_rows.h"
#include "structure/shell/shell_place.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

using Triangle = std::array<Vec3, 3>;

/// Calls `use` with parts of the triangle whose edges are no longer than `longest` [m].
template <class Use>
void cut(const Triangle& t, double longest, const Use& use) {
    double length = 0;
    std::size_t edge = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (const double l = (t[(k + 1) % 3] - t[k]).norm(); l > length) length = l, edge = k;
    if (length <= longest) return use(t);
    const Vec3 &a = t[edge], &b = t[(edge + 1) % 3], &c = t[(edge + 2) % 3], middle = (a + b) / 2;
    cut({a, middle, c}, longest, use);
    cut({middle, b, c}, longest, use);
}

/// The patch as it stood at the start: the body has moved as a rigid one.
HullPatch turned_back(HullPatch patch, const CasePlan& plan, const fs::path& post, double time) {
    BodyPlace at;
    at.centre = plan.moving().motion.mass.centre;
    for (const BodyPlace& p : free_places(plan, post))
        if (p.time <= time * (1 + time_name_precision)) at = p;
    for (Vec3& x : patch.surface.points)
        x = plan.moving().motion.mass.centre + at.attitude.conjugate() * (x - at.centre);
    return patch;
}

}  // namespace

Eigen::SparseMatrix<double> pressures_from_faces(const HullPatch& patch, const structure::Shell& shell, double shown) {
    double smallest = HUGE_VAL;
    for (const structure::Mitc4& element : shell.elements()) smallest = std::min(smallest, element.area());
    std::vector<Eigen::Triplet<double>> shares;
    for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
        const int number = static_cast<int>(t);
        const Triangle whole{patch.surface.corner(number, 0), patch.surface.corner(number, 1),
                             patch.surface.corner(number, 2)};
        cut(whole, std::sqrt(smallest) / 4, [&](const Triangle& part) {
            const int e = structure::nearest_place(shell, (part[0] + part[1] + part[2]) / 3).element;
            const structure::Mitc4& element = shell.elements()[static_cast<std::size_t>(e)];
            const Vec3 area = (part[1] - part[0]).cross(part[2] - part[0]) / 2;  // out of the plate
            shares.emplace_back(e, patch.face_of_triangle[t], area.dot(element.normal()) / (shown * element.area()));
        });
    }
    Eigen::SparseMatrix<double> all(static_cast<Eigen::Index>(shell.elements().size()),
                                    static_cast<Eigen::Index>(patch.faces.size()));
    all.setFromTriplets(shares.begin(), shares.end());
    return all;
}

PlatePressures::PlatePressures(const CasePlan& plan, fs::path case_folder)
    : plan_(plan),
      post_(std::move(case_folder) / "postProcessing"),
      shell_(shell_of(*plan.moving().plate(), plan.moving().plate()->strip())) {}

void PlatePressures::read_before(double limit, RunRecord& record) {
    Table& table = record.table(plate_pressure_table(plan_.moving().name));
    std::map<double, fs::path> folders;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(post_ / "plateSurface", none))
        if (const auto time = time_of(entry.path().filename().string());
            time && *time < limit && (table.time.empty() || *time > table.time.back() * (1 + time_name_precision)))
            folders[*time] = entry.path();
    for (const auto& [time, folder] : folders) {
        const std::optional<HullPatch> patch = read_hull_patch(folder, "plate");
        if (!patch) continue;
        if (!from_faces_ || from_faces_->cols() != static_cast<Eigen::Index>(patch->faces.size()))
            from_faces_ = pressures_from_faces(turned_back(*patch, plan_, post_, time), shell_,
                                               plan_.scene->span() / plan_.moving().plate()->strip());
        Eigen::VectorXd p(from_faces_->cols());
        for (Eigen::Index f = 0; f < p.size(); ++f) p[f] = patch->faces[static_cast<std::size_t>(f)].pressure;
        const Eigen::VectorXd net = *from_faces_ * p;
        const std::size_t row = table.append(time);
        for (Eigen::Index e = 0; e < net.size(); ++e) table.set(row, fmt::format("element_{}", e), "Pa", net[e]);
    }
}

}  // namespace tw
