// A wave that enters with a stream: two boundary conditions of an inlet for interFoam of openfoam.com and openfoam.org 12
// and 13, in the library of the forcing zones. Theory: docs/theory.md, "Regular waves in a tank and in a stream";
// measurements: docs/decisions/088-waves.md.
//
//     0/U             type waveInletVelocity;   value uniform (1.9 0 0);
//     0/alpha.water   type waveInletFraction;   value uniform 0;
//
// Both read constant/inletWave, in which `wave` is that of forcing_zones.C:
//
//     velocity (1.9 0 0);   begin 0.5;   ramp 0.8;   wave { ... }      // of the stream [m/s]; [s]

#include "IFstream.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#include "fixedValueFvPatchFields.H"
#include "volFields.H"
#include "wave_numbers.H"
#ifdef OPENFOAM
#include "fvPatchFieldMapper.H"
#else
#include "fieldMapper.H"
#endif

namespace Foam {

/// The water at a face of the inlet, all of it a function of time, so that a run goes on as it was:
///
///   eta = r eta_wave(x, t)                                    r from 0 at `begin` to 1 after `ramp`: s^2 (3 - 2 s)
///   alpha = the part of the face's height below eta
///   u = u_stream + alpha r (u_wave - current, 0, w_wave)      in the middle of that part
class InletWave {
    vector velocity_;
    scalar begin_, ramp_;
    tw::WaveSum wave_;

public:
    explicit InletWave(const Time& time) {
        IFstream file(time.rootPath()/time.globalCaseName()/"constant"/"inletWave");
        const dictionary dict(file);
        dict.lookup("velocity") >> velocity_;
        dict.lookup("begin") >> begin_;
        dict.lookup("ramp") >> ramp_;
        wave_ = takeWave(dict.subDict("wave"));
    }

    /// Fraction of water and velocity of each face at time t.
    void at(const polyPatch& faces, scalar t, scalarField& water, vectorField& velocity) const {
        const scalar s = min(max((t - begin_)/ramp_, scalar(0)), scalar(1)), share = s*s*(3 - 2*s);
        water.setSize(faces.size());
        velocity.setSize(faces.size());
        forAll(faces, face) {
            scalar low = GREAT, high = -GREAT, x = 0;
            for (const label i : faces[face]) {
                const point& corner = faces.points()[i];
                low = min(low, corner.z());
                high = max(high, corner.z());
                x += corner.x()/faces[face].size();
            }
            const scalar eta = share*tw::wave_surface(wave_, x, t);
            water[face] = min(max((eta - low)/(high - low), scalar(0)), scalar(1));
            double u, w;
            tw::wave_velocity(wave_, x, (low + min(high, eta))/2, t, u, w);
            velocity[face] = velocity_ + water[face]*share*vector(u - wave_.current, 0, w);
        }
    }
};

#ifdef OPENFOAM
using InletMapper = fvPatchFieldMapper;
/// A copy without a field of its own, which openfoam.org does not have, and clones.
#define INLET_WAVE_CLONES(Condition, Type)                                                       \
    Condition(const Condition& other) : Condition(other, other.internalField()) {}               \
    tmp<fvPatchField<Type>> clone() const override {                                             \
        return tmp<fvPatchField<Type>>(new Condition(*this));                                    \
    }                                                                                            \
    tmp<fvPatchField<Type>> clone(const DimensionedField<Type, volMesh>& inside) const override { \
        return tmp<fvPatchField<Type>>(new Condition(*this, inside));                            \
    }
#else
using InletMapper = fieldMapper;
#define INLET_WAVE_CLONES(Condition, Type)                                                       \
    tmp<fvPatchField<Type>> clone(const DimensionedField<Type, volMesh>& inside) const override { \
        return tmp<fvPatchField<Type>>(new Condition(*this, inside));                            \
    }
#endif

class waveInletVelocityFvPatchVectorField : public fixedValueFvPatchVectorField {
    using This = waveInletVelocityFvPatchVectorField;
    using Inside = DimensionedField<vector, volMesh>;
    InletWave wave_;

public:
    TypeName("waveInletVelocity");

#ifdef OPENFOAM
    waveInletVelocityFvPatchVectorField(const fvPatch& p, const Inside& inside)
        : fixedValueFvPatchVectorField(p, inside), wave_(inside.db().time()) {}
#endif
    waveInletVelocityFvPatchVectorField(const fvPatch& p, const Inside& inside, const dictionary& dict)
        : fixedValueFvPatchVectorField(p, inside, dict), wave_(inside.db().time()) {}
    waveInletVelocityFvPatchVectorField(const This& other, const fvPatch& p, const Inside& inside,
                                        const InletMapper& mapper)
        : fixedValueFvPatchVectorField(other, p, inside, mapper), wave_(other.wave_) {}
    waveInletVelocityFvPatchVectorField(const This& other, const Inside& inside)
        : fixedValueFvPatchVectorField(other, inside), wave_(other.wave_) {}
    INLET_WAVE_CLONES(waveInletVelocityFvPatchVectorField, vector)

    void updateCoeffs() override {
        if (updated()) return;
        scalarField water;
        vectorField velocity;
        wave_.at(patch().patch(), db().time().value(), water, velocity);
        fvPatchField<vector>::operator==(velocity);
        fixedValueFvPatchVectorField::updateCoeffs();
    }
};
makePatchTypeField(fvPatchVectorField, waveInletVelocityFvPatchVectorField);

class waveInletFractionFvPatchScalarField : public fixedValueFvPatchScalarField {
    using This = waveInletFractionFvPatchScalarField;
    using Inside = DimensionedField<scalar, volMesh>;
    InletWave wave_;

public:
    TypeName("waveInletFraction");

#ifdef OPENFOAM
    waveInletFractionFvPatchScalarField(const fvPatch& p, const Inside& inside)
        : fixedValueFvPatchScalarField(p, inside), wave_(inside.db().time()) {}
#endif
    waveInletFractionFvPatchScalarField(const fvPatch& p, const Inside& inside, const dictionary& dict)
        : fixedValueFvPatchScalarField(p, inside, dict), wave_(inside.db().time()) {}
    waveInletFractionFvPatchScalarField(const This& other, const fvPatch& p, const Inside& inside,
                                        const InletMapper& mapper)
        : fixedValueFvPatchScalarField(other, p, inside, mapper), wave_(other.wave_) {}
    waveInletFractionFvPatchScalarField(const This& other, const Inside& inside)
        : fixedValueFvPatchScalarField(other, inside), wave_(other.wave_) {}
    INLET_WAVE_CLONES(waveInletFractionFvPatchScalarField, scalar)

    void updateCoeffs() override {
        if (updated()) return;
        scalarField water;
        vectorField velocity;
        wave_.at(patch().patch(), db().time().value(), water, velocity);
        fvPatchField<scalar>::operator==(water);
        fixedValueFvPatchScalarField::updateCoeffs();
    }
};
makePatchTypeField(fvPatchScalarField, waveInletFractionFvPatchScalarField);

}  // namespace Foam
