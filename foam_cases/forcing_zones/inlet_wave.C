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
//
// or, for the types waveInletVelocityOfASea and waveInletFractionOfASea, in its place a sum of linear waves, with their
// frequencies in the water and the stream that carries them:
//
//     sea { depth 1; direction 1; current 1.9; stream 1.9; k (6.28 ...); omega (7.8 ...); amplitude ( ... ); phase ( ... ); }

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
    bool isSea_;
    tw::WaveSum wave_;
    tw::WaveComponents sea_;

    scalar share(scalar t) const {
        const scalar s = min(max((t - begin_) / ramp_, scalar(0)), scalar(1));
        return s * s * (3 - 2 * s);
    }

    /// Calls `use(face, x, low, top, water)` for each: its middle and lowest end [m], the end of its water [m] and how much
    /// of its height that is.
    template <class Use>
    void each(const polyPatch& faces, scalar t, const Use& use) const {
        forAll(faces, face) {
            scalar low = GREAT, high = -GREAT, x = 0;
            for (const label i : faces[face]) {
                const point& corner = faces.points()[i];
                low = min(low, corner.z());
                high = max(high, corner.z());
                x += corner.x()/faces[face].size();
            }
            const scalar eta = share(t) * (isSea_ ? tw::wave_surface(sea_, x, t) : tw::wave_surface(wave_, x, t));
            use(face, x, low, min(high, eta), min(max((eta - low) / (high - low), scalar(0)), scalar(1)));
        }
    }

public:
    explicit InletWave(const Time& time) {
        IFstream file(time.rootPath() / time.globalCaseName() / "constant" / "inletWave");
        const dictionary dict(file);
        dict.lookup("velocity") >> velocity_;
        dict.lookup("begin") >> begin_;
        dict.lookup("ramp") >> ramp_;
        isSea_ = dict.found("sea");
        if (isSea_)
            sea_ = takeSea(dict.subDict("sea"));
        else
            wave_ = takeWave(dict.subDict("wave"));
    }

    /// Fraction of water of each face at time t.
    tmp<scalarField> at(const polyPatch& faces, scalar t, const scalarField&) const {
        tmp<scalarField> fraction(new scalarField(faces.size()));
        scalarField& values = fraction.ref();
        each(faces, t, [&](label face, scalar, scalar, scalar, scalar water) { values[face] = water; });
        return fraction;
    }

    /// Velocity of each face at time t.
    tmp<vectorField> at(const polyPatch& faces, scalar t, const vectorField&) const {
        tmp<vectorField> velocity(new vectorField(faces.size(), velocity_));
        vectorField& values = velocity.ref();
        const tw::WaveMoment now = isSea_ ? tw::wave_moment(sea_, t) : tw::WaveMoment();
        each(faces, t, [&](label face, scalar x, scalar low, scalar top, scalar water) {
            double u, w;
            if (isSea_)
                tw::wave_velocity(now, x, (low + top) / 2, u, w);
            else
                tw::wave_velocity(wave_, x, (low + top) / 2, t, u, w);
            values[face] += water * share(t) * vector(u - (isSea_ ? sea_.current : wave_.current), 0, w);
        });
        return velocity;
    }
};

#ifdef OPENFOAM
using InletMapper = fvPatchFieldMapper;
#else
using InletMapper = fieldMapper;
#endif

/// What both conditions share; `Condition`: the one that this is a part of.
template <class Condition, class Type>
class WaveInlet : public fixedValueFvPatchField<Type> {
    using Fixed = fixedValueFvPatchField<Type>;
    using Inside = DimensionedField<Type, volMesh>;
    InletWave wave_;

    const Condition& whole() const { return static_cast<const Condition&>(*this); }

public:
    WaveInlet(const fvPatch& p, const Inside& inside, const dictionary& dict)
        : Fixed(p, inside, dict), wave_(inside.db().time()) {}
    WaveInlet(const Condition& other, const fvPatch& p, const Inside& inside, const InletMapper& mapper)
        : Fixed(other, p, inside, mapper), wave_(other.wave_) {}
    WaveInlet(const Condition& other, const Inside& inside) : Fixed(other, inside), wave_(other.wave_) {}
#ifdef OPENFOAM
    // without a field of its own, or values, which openfoam.org does not have
    WaveInlet(const fvPatch& p, const Inside& inside) : Fixed(p, inside), wave_(inside.db().time()) {}
    tmp<fvPatchField<Type>> clone() const override {
        return tmp<fvPatchField<Type>>(new Condition(whole(), this->internalField()));
    }
#endif
    tmp<fvPatchField<Type>> clone(const Inside& inside) const override {
        return tmp<fvPatchField<Type>>(new Condition(whole(), inside));
    }

    void updateCoeffs() override {
        if (this->updated()) return;
        fvPatchField<Type>::operator==(wave_.at(this->patch().patch(), this->db().time().value(), *this));
        Fixed::updateCoeffs();
    }
};

struct waveInletVelocityFvPatchVectorField : WaveInlet<waveInletVelocityFvPatchVectorField, vector> {
    using WaveInlet::WaveInlet;
    TypeName("waveInletVelocity");
};
makePatchTypeField(fvPatchVectorField, waveInletVelocityFvPatchVectorField);

struct waveInletFractionFvPatchScalarField : WaveInlet<waveInletFractionFvPatchScalarField, scalar> {
    using WaveInlet::WaveInlet;
    TypeName("waveInletFraction");
};
makePatchTypeField(fvPatchScalarField, waveInletFractionFvPatchScalarField);

// The types that a case names where it gives a sum of waves: a library built before these existed knows no such type.
addNamedToRunTimeSelectionTable(fvPatchVectorField, waveInletVelocityFvPatchVectorField, dictionary,
                                waveInletVelocityOfASea);
addNamedToRunTimeSelectionTable(fvPatchScalarField, waveInletFractionFvPatchScalarField, dictionary,
                                waveInletFractionOfASea);

}  // namespace Foam
