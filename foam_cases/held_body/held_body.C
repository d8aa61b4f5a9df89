// A body that is held until its release: a solver of six degrees of freedom for interFoam of openfoam.com and openfoam.org
// 12 and 13, in a library of its own; tools/build_openfoam_solvers.sh builds it for Debian's OpenFOAM,
// tools/build_openfoam_walls.sh for the one whose environment is loaded. Measurements: docs/decisions/032-rigid-bodies.md.
//
//     constant/dynamicMeshDict, sixDoFRigidBodyMotion:
//
//     solver { type heldNewmark; release 0.4; gamma 0.5; }      // [s]; the rest as of Newmark

#include "Newmark.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#ifndef OPENFOAM
#include "motionSolver.H"
#include "polyMesh.H"
#endif

namespace Foam {
namespace sixDoFSolvers {

/// Keeps the body where it is, at rest, in each time step whose middle lies before the release; then as Newmark. That is
/// a function of time alone, so a run that is continued holds and releases as it would have.
class heldNewmark : public Newmark {
    scalar release_;  ///< [s]

    const Time& time() const {
#ifdef OPENFOAM
        return body_.time();
#else  // has no clock; it is a base of the motion solver, which is not made yet when this is
        return dynamic_cast<const motionSolver&>(body_).mesh().time();
#endif
    }

public:
    TypeName("heldNewmark");

    heldNewmark(const dictionary& dict, sixDoFRigidBodyMotion& body) : Newmark(dict, body), release_(0) {
        dict.lookup("release") >> release_;
    }
#ifdef OPENFOAM
    autoPtr<sixDoFSolver> clone() const override { return autoPtr<sixDoFSolver>(new heldNewmark(dict_, body_)); }
#endif

    void solve(bool firstIter, const vector& force, const vector& torque, scalar deltaT, scalar deltaT0) override {
        if (time().value() - deltaT/2 >= release_) {
            Newmark::solve(firstIter, force, torque, deltaT, deltaT0);
            return;
        }
        // OpenFOAM relaxes no acceleration before this was called once: that of the release begins from rest.
        updateAcceleration(force, torque);
        centreOfRotation() = centreOfRotation0();
        Q() = Q0();
        v() = a() = pi() = tau() = Zero;
    }
};

defineTypeNameAndDebug(heldNewmark, 0);
addToRunTimeSelectionTable(sixDoFSolver, heldNewmark, dictionary);

}  // namespace sixDoFSolvers
}  // namespace Foam
