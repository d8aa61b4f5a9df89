#include "foam_cases/files/case_files.h"
#include "foam_cases/files/times_of_table.h"

// Why this and not a mesh that moves: docs/decisions/042-moving-tanks.md.

namespace tw {
namespace {

/// Rows of time, acceleration, spin and angular acceleration. OpenFOAM takes the acceleration off gravity, so that its
/// part is balanced at the faces as gravity is, and adds, with r from the origin of the axes,
///
///   - (2 omega x U + omega x (omega x r) + alpha x r)
///
/// So the acceleration is that of the origin, and holds the turn of gravity in the tank's axes as well.
struct TableOfAcceleration {
    List origin, spin, turn, all;
};

TableOfAcceleration table_of_acceleration(const CasePlan& plan) {
    const MovingFrame& frame = *plan.scene->tank_motion;
    const Vec3 gravity(0, 0, -plan.scene->water.gravity);
    TableOfAcceleration table;
    for (const double t : times_of_table(frame.law, plan.scene->run.duration, plan.largest_step)) {
        const Vec3 origin = gravity - frame.force(t, gravity).at(Vec3::Zero(), Vec3::Zero());
        const MotionLaw::At now = frame.law.at(t);
        const Vec3 axis = frame.law.turns ? frame.law.axis : Vec3(Vec3::Zero());
        const Vec3 spin = now.rate * axis, turn = now.acceleration * axis;
        table.origin.push_back(List{t, origin});
        table.spin.push_back(List{t, spin});
        table.turn.push_back(List{t, turn});
        table.all.push_back(List{t, List{origin, spin, turn}});
    }
    return table;
}

}  // namespace

std::vector<CaseFile> tank_motion_files(const CasePlan& plan) {
    if (!plan.scene->tank_motion) return {};
    const Flavour& f = plan.flavour;
    const TableOfAcceleration table = table_of_acceleration(plan);
    const auto sources = [&](const Dictionary& tank) {
        Dictionary all{{"tank", tank}};
        add_zones(plan.zones, all);
        return all;
    };
    if (f.tables_in_files()) {
        const Dictionary source{{"type", Word("tabulatedAccelerationSource")},
                                {"active", true},
                                {"timeDataFileName", Quoted("<case>/constant/accelerationOfTank.dat")}};
        return {{"constant/fvOptions", foam_file("dictionary", "fvOptions", sources(source))},
                {"constant/accelerationOfTank.dat", Value(table.all).text() + "\n"}};
    }
    Dictionary model{{"type", Word("sixDoFAccelerationSource")}};  // which later releases still know
    if (f.motion_in_parts())
        model.add({{"acceleration", f.table_of_times(table.origin)},
                   {"angularVelocity", f.table_of_times(table.spin)},
                   {"angularAcceleration", f.table_of_times(table.turn)}});
    else
        model.add("accelerations", f.table_of_times(table.all));
    return {{"constant/fvModels", foam_file("dictionary", "fvModels", sources(model))}};
}

}  // namespace tw
