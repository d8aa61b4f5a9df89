// Forcing zones: a source of momentum for interFoam of openfoam.com (an fvOption) and openfoam.org 12 and 13 (an
// fvModel of incompressibleVoF) that draws the flow to the undisturbed stream and so absorbs waves before they meet an
// end of the domain. A library of its own; tools/build_openfoam_solvers.sh builds it for Debian's OpenFOAM,
// tools/build_openfoam_walls.sh for the one whose environment is loaded. Theory: docs/theory.md, "Forcing zones";
// measurements: docs/decisions/082-zones-and-ends.md.
//
//     constant/fvOptions, constant/fvModels
//
//     forcingZones
//     {
//         type        forcingZones;
//         velocity    (0.7 0 0);                                              // u_ref [m/s]
//         zones       ( { axis 0; begin 2.5; end 3; strength 14; } ... );     // [m], [1/s]
//     }
//
// A zone with `makesWave true;` draws the flow to a steady wave, whose numbers are those of waves/wave_sum.h:
//
//         wave { k 6.28; depth 1; direction 1; speed 1.25; phase 0; current 0; crest 0.02; U (0.06 ...); eta (0.02 ...); }
//
// or to a sum of linear ones (waves/wave_components.h):
//
//         sea { depth 1; direction 1; current 0; k (6.28 ...); omega (7.8 ...); amplitude (0.002 ...); phase (0.3 ...); }
//
// A steady wave under an angle to x has `across`, its sine, beside `direction`, its cosine.

#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "volFields.H"
#include "wave_numbers.H"
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
        bool makesWave;
    };
    vector velocity_;
    tw::WaveSum wave_;
    bool isSea_;
    tw::WaveComponents sea_;
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
            zone.makesWave = zones[i].found("makesWave") && (dict.found("wave") || dict.found("sea"));
        }
        isSea_ = dict.found("sea");
        if (isSea_) sea_ = takeSea(dict.subDict("sea"));
        if (dict.found("wave")) wave_ = takeWave(dict.subDict("wave"));
    }

    /// [1/s], and whether the zone that has it makes the wave.
    scalar rate(const point& place, bool& makesWave) const {
        scalar rate = 0;
        makesWave = false;
        for (const Zone& zone : zones_) {
            const scalar s = (place[zone.axis] - zone.begin)/(zone.end - zone.begin);
            const scalar here = s > 0 ? zone.strength*sqr(min(s, scalar(1))) : 0;
            if (here > rate) rate = here, makesWave = zone.makesWave;
        }
        return rate;
    }

    vector target(const point& place, bool makesWave, const tw::WaveMoment& now) const {
        if (!makesWave) return velocity_;
        double u, v, w;
        if (isSea_)
            tw::wave_velocity(now, place.x(), place.y(), place.z(), u, v, w);
        else
            tw::wave_velocity(wave_, place.x(), place.y(), place.z(), mesh().time().value(), u, v, w);
        return vector(u, v, w);
    }

    /// eqn is the right-hand side of the momentum equation: its diagonal takes -a u, its source -a u_ref.
    void force(const volScalarField& rho, fvMatrix<vector>& eqn) const {
        const volVectorField& centres = mesh().C();
        const scalarField& volumes = mesh().V();
        scalarField& diagonal = eqn.diag();
        vectorField& source = eqn.source();
        const tw::WaveMoment now = isSea_ ? tw::wave_moment(sea_, mesh().time().value()) : tw::WaveMoment();
        forAll(diagonal, cell) {
            bool makesWave;
            const scalar here = rate(centres[cell], makesWave);
            if (here == 0) continue;
            const scalar a = rho[cell]*here*volumes[cell];
            diagonal[cell] -= a;
            source[cell] -= a*target(centres[cell], makesWave, now);
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
// The types that a case names where it gives a sum of waves, or waves under an angle: a library built before these
// existed knows no such type, and OpenFOAM stops there in place of drawing the making zone to rest or to head waves.
addNamedToRunTimeSelectionTable(Source, forcingZones, dictionary, forcingZonesOfASea);
addNamedToRunTimeSelectionTable(Source, forcingZones, dictionary, forcingZonesOblique);

}  // namespace fv
}  // namespace Foam
