// Forcing zones: a source of momentum for interFoam of openfoam.com (an fvOption) and openfoam.org 12 and 13 (an
// fvModel of incompressibleVoF) that draws the flow to the undisturbed stream and so absorbs waves before they meet an
// end of the domain. A library of its own; tools/build_openfoam_solvers.sh builds it for Debian's OpenFOAM,
// tools/build_openfoam_walls.sh for the one whose environment is loaded. Theory: docs/theory.md, "Forcing zones";
// measurements: docs/decisions/083-forcing-zones-in-interfoam.md.
//
//     constant/fvOptions, constant/fvModels
//
//     forcingZones
//     {
//         type        forcingZones;
//         velocity    (0.7 0 0);                                              // u_ref [m/s]
//         zones       ( { axis 0; begin 2.5; end 3; strength 14; } ... );     // [m], [1/s]
//     }

#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "volFields.H"
#ifdef OPENFOAM
#include "fvOption.H"
#else
#include "fvModel.H"
#endif

namespace Foam {
namespace fv {

#ifdef OPENFOAM
using Source = option;
#else
using Source = fvModel;
#endif

/// With s from 0 where a zone begins to 1 at its end (the domain's face, and beyond it), each cell obeys
///
///   du/dt += gamma s^2 (u_ref - u)         gamma: the zone's strength
///
/// (Peric & Abdel-Maksoud, Ocean Eng. 147 (2018) 132, arXiv:1705.06940), as a force rho gamma s^2 (u_ref - u), implicit
/// in u: no step is too long for it. Where zones overlap the strongest holds.
class forcingZones : public Source {
    struct Zone {
        label axis;
        scalar begin, end, strength;
    };
    vector velocity_;
    List<Zone> zones_;

    void take(const dictionary& dict) {
        dict.lookup("velocity") >> velocity_;
        const PtrList<dictionary> zones(dict.lookup("zones"));
        zones_.setSize(zones.size());
        forAll(zones, i) {
            Zone& zone = zones_[i];
            zones[i].lookup("axis") >> zone.axis;
            zones[i].lookup("begin") >> zone.begin;
            zones[i].lookup("end") >> zone.end;
            zones[i].lookup("strength") >> zone.strength;
        }
    }

    /// [1/s]
    scalar rate(const point& place) const {
        scalar rate = 0;
        for (const Zone& zone : zones_) {
            const scalar s = (place[zone.axis] - zone.begin)/(zone.end - zone.begin);
            if (s > 0) rate = max(rate, zone.strength*sqr(min(s, scalar(1))));
        }
        return rate;
    }

    /// eqn is the right-hand side of the momentum equation: its diagonal takes -a u, its source -a u_ref.
    void force(const volScalarField& rho, fvMatrix<vector>& eqn) const {
        const volVectorField& centres = mesh().C();
        const scalarField& volumes = mesh().V();
        scalarField& diagonal = eqn.diag();
        vectorField& source = eqn.source();
        forAll(diagonal, cell) {
            const scalar here = rate(centres[cell]);
            if (here == 0) continue;
            const scalar a = rho[cell]*here*volumes[cell];
            diagonal[cell] -= a;
            source[cell] -= a*velocity_;
        }
    }

public:
    TypeName("forcingZones");

#ifdef OPENFOAM
    forcingZones(const word& name, const word& modelType, const dictionary& dict, const fvMesh& mesh)
        : Source(name, modelType, dict, mesh) {
        fieldNames_ = wordList(1, "U");
        applied_.setSize(1, false);
        take(coeffs_);
    }
    bool read(const dictionary& dict) override {
        if (!Source::read(dict)) return false;
        take(coeffs_);
        return true;
    }
    using Source::addSup;
    void addSup(const volScalarField& rho, fvMatrix<vector>& eqn, const label) override { force(rho, eqn); }
#else
    forcingZones(const word& name, const word& modelType, const fvMesh& mesh, const dictionary& dict)
        : Source(name, modelType, mesh, dict) {
        take(dict);
    }
    wordList addSupFields() const override { return wordList(1, "U"); }
    bool read(const dictionary& dict) override {
        if (!Source::read(dict)) return false;
        take(dict);
        return true;
    }
    using Source::addSup;
    void addSup(const volScalarField& rho, const volVectorField&, fvMatrix<vector>& eqn) const override {
        force(rho, eqn);
    }
    bool movePoints() override { return true; }
    void topoChange(const polyTopoChangeMap&) override {}
    void mapMesh(const polyMeshMap&) override {}
    void distribute(const polyDistributionMap&) override {}
#endif
};

defineTypeNameAndDebug(forcingZones, 0);
addToRunTimeSelectionTable(Source, forcingZones, dictionary);

}  // namespace fv
}  // namespace Foam
