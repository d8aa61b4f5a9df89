// Walls from which water lets go: boundary conditions for interFoam of openfoam.com and openfoam.org (incompressibleVoF
// from 11 on), a library of their own. tools/build_openfoam_solvers.sh builds it for Debian's OpenFOAM,
// tools/build_openfoam_walls.sh for the one whose environment is loaded; what differs between them is in release.H. Theory:
// docs/theory.md, "Walls that let water go"; measurements: docs/decisions/061-walls-that-let-go.md.
//
//     0/p_rgh         type ventilatedWallPressure;   value uniform 0;
//     0/alpha.water   type ventilatedWallFraction;   value uniform 0;
//     0/U             type ventilatedWallVelocity;   value uniform (0 0 0);   of a body that moves, openfoam.com alone
//     0/U             type ventilatedSlip;                                    of a wall at rest in short steps, likewise
//
// The velocity of other walls keeps its condition.

#include "fixedFluxPressureFvPatchScalarField.H"
#include "mixedFvPatchFields.H"
#ifdef OPENFOAM
#include "movingWallVelocityFvPatchVectorField.H"
#include "slipFvPatchFields.H"
#endif
#include "release.H"
#include "surfaceFields.H"
#include "syncTools.H"

namespace Foam {

/// p_rgh at a wall that holds no water under tension where air can come. With u the speed of what comes in through a
/// face and p the pressure at it above that of the air, each face beside air obeys
///
///   u >= 0,  p >= 0,  u p = 0                    (Signorini's condition)
///
/// It is a wall (u = 0, the gradient of p_rgh from the flux) or an opening to air (p = 0). A wall opens where its
/// pressure is below the air's, an opening closes where something would go out; both are decided from the last solution
/// before each pressure equation. Air can come to a face whose cell, or that of a neighbour along the wall, is air for
/// more than a half, and to the neighbours of a face that was open at the end of the last time step: the line along
/// which the water leaves moves by at most one face in a step. All other faces are those of fixedFluxPressure: deep
/// under water suction stays.
class ventilatedWallPressureFvPatchScalarField : public fixedFluxPressureFvPatchScalarField {
    static constexpr scalar airBelow = 0.5;    ///< water fraction of a cell below which it brings air to its neighbours
    static constexpr scalar waterAbove = 0.01;  ///< below, there is no water that could be let go

    scalarField open_;     ///< 1: an opening, 0: a wall
    scalarField wasOpen_;  ///< at the end of the last time step
    scalarField ofAir_;    ///< p_rgh at which the pressure is the air's [Pa]
    label step_ = -1;      ///< for which wasOpen_ holds
    label equations_ = 0;  ///< of the pressure, so far
    bool decided_ = false;  ///< for the next of them

    void closeAll() {
        for (scalarField* field : {&open_, &wasOpen_, &ofAir_}) *field = scalarField(this->size(), 0.0);
    }

    void setAir() {
        const scalarField& rho = patch().lookupPatchField<volScalarField, scalar>("rho");
        ofAir_ = -rho * (released::gravity(db()) & patch().Cf());
    }

public:
    TypeName("ventilatedWallPressure");

#ifdef OPENFOAM  // openfoam.org has none of these without a dictionary
    ventilatedWallPressureFvPatchScalarField(const fvPatch& p, const DimensionedField<scalar, volMesh>& field)
        : fixedFluxPressureFvPatchScalarField(p, field) {
        closeAll();
    }
#endif
    ventilatedWallPressureFvPatchScalarField(const fvPatch& p, const DimensionedField<scalar, volMesh>& field,
                                             const dictionary& dict)
        : fixedFluxPressureFvPatchScalarField(p, field, dict) {
        closeAll();
        if (dict.found("open")) open_ = released::field("open", dict, p.size());
    }
    ventilatedWallPressureFvPatchScalarField(const ventilatedWallPressureFvPatchScalarField& other, const fvPatch& p,
                                             const DimensionedField<scalar, volMesh>& field,
                                             const released::Mapper& mapper)
        : fixedFluxPressureFvPatchScalarField(other, p, field, mapper) {
        closeAll();
    }
    ventilatedWallPressureFvPatchScalarField(const ventilatedWallPressureFvPatchScalarField& other,
                                             const DimensionedField<scalar, volMesh>& field)
        : fixedFluxPressureFvPatchScalarField(other, field),
          open_(other.open_),
          wasOpen_(other.wasOpen_),
          ofAir_(other.ofAir_),
          step_(other.step_),
          equations_(other.equations_),
          decided_(other.decided_) {}
    RELEASED_CLONES(ventilatedWallPressureFvPatchScalarField, scalar)

    const scalarField& open() const { return open_; }
    label equations() const { return equations_; }

    /// Which faces are open in the next equation of the pressure, from the last solution. `throughWall`: flux of the wall's
    /// own velocity, where phi contains it.
    void decide(const scalarField& throughWall) {
        if (decided_) return;
        decided_ = true;
        if (step_ != db().time().timeIndex()) {
            step_ = db().time().timeIndex();
            wasOpen_ = open_;
        }
        const scalarField water(
            patch().lookupPatchField<volScalarField, scalar>("alpha.water").patchInternalField());
        setAir();
        const scalarField phi(patch().lookupPatchField<surfaceScalarField, scalar>("phi") - throughWall);
        const polyPatch& faces = patch().patch();
        // By points, so that neighbours on other processors count.
        boolList beside(patch().boundaryMesh().mesh().nPoints(), false);
        forAll(open_, face)
            if (water[face] < airBelow || wasOpen_[face] > 0.5)
                for (const label point : faces[face]) beside[point] = true;
        syncTools::syncPointList(patch().boundaryMesh().mesh(), beside, orEqOp<bool>(), false);
        label opened = 0;
        forAll(open_, face) {
            bool airCanCome = false;
            for (const label point : faces[face]) airCanCome = airCanCome || beside[point];
            const bool pulled = open_[face] > 0.5 ? phi[face] <= 0 : (*this)[face] < ofAir_[face];
            open_[face] = airCanCome && pulled && water[face] > waterAbove ? 1 : 0;
            opened += open_[face] > 0.5 ? 1 : 0;
        }
        if (debug)
            Info<< type() << " " << patch().name() << ": " << returnReduce(opened, sumOp<label>())
                << " faces are open" << endl;
    }

    /// Called by the solver before each pressure equation with the gradient of a wall.
    using fixedFluxPressureFvPatchScalarField::updateCoeffs;
    void RELEASED_TAKE_GRADIENT(const scalarField& gradientOfWall) override {
        if (updated()) return;
        decide(scalarField(this->size(), 0.0));
        setAir();  // the water has moved since, where it was decided before
        decided_ = false;
        ++equations_;
        fixedFluxPressureFvPatchScalarField::RELEASED_TAKE_GRADIENT(gradientOfWall);
    }

    tmp<scalarField> snGrad() const override {
        return open_*(ofAir_ - patchInternalField())*patch().deltaCoeffs() + (1 - open_)*gradient();
    }
    void evaluate(const Pstream::commsTypes comms) override {
        fixedFluxPressureFvPatchScalarField::evaluate(comms);
        scalarField::operator=(open_*ofAir_ + (1 - open_)*(*this));
    }
    tmp<scalarField> valueInternalCoeffs(const tmp<scalarField>&) const override { return 1 - open_; }
    tmp<scalarField> valueBoundaryCoeffs(const tmp<scalarField>&) const override {
        return open_*ofAir_ + (1 - open_)*gradient()/patch().deltaCoeffs();
    }
    tmp<scalarField> gradientInternalCoeffs() const override { return -open_*patch().deltaCoeffs(); }
    tmp<scalarField> gradientBoundaryCoeffs() const override {
        return open_*ofAir_*patch().deltaCoeffs() + (1 - open_)*gradient();
    }
    void write(Ostream& os) const override {
        fixedFluxPressureFvPatchScalarField::write(os);
        released::write(os, "open", open_);
    }
};

makePatchTypeField(fvPatchScalarField, ventilatedWallPressureFvPatchScalarField);

/// alpha.water at such a wall: what comes in through an opening is air; no gradient elsewhere.
class ventilatedWallFractionFvPatchScalarField : public mixedFvPatchScalarField {
    void asWall() {
        for (scalarField* field : {&refValue(), &refGrad(), &valueFraction()}) *field = 0;
    }

public:
    TypeName("ventilatedWallFraction");

    ventilatedWallFractionFvPatchScalarField(const fvPatch& p, const DimensionedField<scalar, volMesh>& field)
        : mixedFvPatchScalarField(p, field) {
        asWall();
    }
    ventilatedWallFractionFvPatchScalarField(const fvPatch& p, const DimensionedField<scalar, volMesh>& field,
                                             const dictionary& dict)
        : mixedFvPatchScalarField(p, field) {
        asWall();
        if (dict.found("value"))
            scalarField::operator=(released::field("value", dict, p.size()));
        else
            scalarField::operator=(patchInternalField());
    }
    ventilatedWallFractionFvPatchScalarField(const ventilatedWallFractionFvPatchScalarField& other, const fvPatch& p,
                                             const DimensionedField<scalar, volMesh>& field,
                                             const released::Mapper& mapper)
        : mixedFvPatchScalarField(other, p, field, mapper) {}
    ventilatedWallFractionFvPatchScalarField(const ventilatedWallFractionFvPatchScalarField& other,
                                             const DimensionedField<scalar, volMesh>& field)
        : mixedFvPatchScalarField(other, field) {}
    RELEASED_CLONES(ventilatedWallFractionFvPatchScalarField, scalar)

    bool fixesValue() const override { return false; }  // it would take part in the bounds of the water fraction
    void updateCoeffs() override {
        if (updated()) return;
        asWall();
        if (db().foundObject<surfaceScalarField>("phi") && db().foundObject<volScalarField>("p_rgh")) {
            const fvPatchScalarField& p = patch().lookupPatchField<volScalarField, scalar>("p_rgh");
            const scalarField& phi = patch().lookupPatchField<surfaceScalarField, scalar>("phi");
            if (isA<ventilatedWallPressureFvPatchScalarField>(p))  // not phi alone: it is rounded at walls that move
                valueFraction() = refCast<const ventilatedWallPressureFvPatchScalarField>(p).open()*neg(phi);
        }
        mixedFvPatchScalarField::updateCoeffs();
    }
    void write(Ostream& os) const override {
        fvPatchScalarField::write(os);
        released::write(os, "value", *this);
    }
};

makePatchTypeField(fvPatchScalarField, ventilatedWallFractionFvPatchScalarField);

#ifdef OPENFOAM  // openfoam.org's builds were not tried with it

/// The pressure's condition at the same patch, if it is one of these walls and there are fluxes already.
inline ventilatedWallPressureFvPatchScalarField* lettingGo(const fvPatch& patch, const objectRegistry& fields) {
    if (!fields.foundObject<surfaceScalarField>("phi") || !fields.foundObject<volScalarField>("p_rgh")) return nullptr;
    fvPatchScalarField& p = fields.lookupObjectRef<volScalarField>("p_rgh").boundaryFieldRef()[patch.index()];
    return isA<ventilatedWallPressureFvPatchScalarField>(p) ? &refCast<ventilatedWallPressureFvPatchScalarField>(p)
                                                            : nullptr;
}

/// Velocity of what came in through the openings at the end of the last time step, relative to the wall. The solver takes
/// the flux through a face but for the pressure's part from the velocity at the patch,
///
///   u = U n - (dt/rho) dp/dn
///
/// so that with the wall's alone what comes in would be started from rest in each step, by a suction of rho u L/dt (L: from
/// the cell's middle to the wall) that the water beside it feels: the shorter the step, the more, without end.
inline tmp<vectorField> inflow(const ventilatedWallPressureFvPatchScalarField& wall, const fvPatch& patch) {
    const surfaceScalarField& phi = wall.db().lookupObject<surfaceScalarField>("phi");
    const scalarField before(phi.oldTime().boundaryField()[patch.index()] / patch.magSf());
    return wall.open() * min(before, scalar(0)) * patch.nf();
}

/// The velocity of such a wall that moves: the wall's, and at openings with what comes in. Once the mesh has moved the solver
/// asks for the fluxes through such patches anew, by their velocity, and corrects all others by them: openings have them
/// still.
class ventilatedWallVelocityFvPatchVectorField : public movingWallVelocityFvPatchVectorField {
    label equations_ = 0;  ///< of the pressure, when the velocity was asked for the last time

    void takeWall() {
        movingWallVelocityFvPatchVectorField::updateCoeffs();
        vectorField& U = *this;
        if (!patch().boundaryMesh().mesh().moving()) U = Zero;  // which it leaves as it is
    }

public:
    TypeName("ventilatedWallVelocity");

    ventilatedWallVelocityFvPatchVectorField(const fvPatch& p, const DimensionedField<vector, volMesh>& field)
        : movingWallVelocityFvPatchVectorField(p, field) {}
    ventilatedWallVelocityFvPatchVectorField(const fvPatch& p, const DimensionedField<vector, volMesh>& field,
                                             const dictionary& dict)
        : movingWallVelocityFvPatchVectorField(p, field, dict) {}
    ventilatedWallVelocityFvPatchVectorField(const ventilatedWallVelocityFvPatchVectorField& other, const fvPatch& p,
                                             const DimensionedField<vector, volMesh>& field,
                                             const released::Mapper& mapper)
        : movingWallVelocityFvPatchVectorField(other, p, field, mapper) {}
    ventilatedWallVelocityFvPatchVectorField(const ventilatedWallVelocityFvPatchVectorField& other,
                                             const DimensionedField<vector, volMesh>& field)
        : movingWallVelocityFvPatchVectorField(other, field), equations_(other.equations_) {}
    RELEASED_CLONES(ventilatedWallVelocityFvPatchVectorField, vector)

    void updateCoeffs() override {
        if (updated()) return;
        takeWall();
        ventilatedWallPressureFvPatchScalarField* wall = lettingGo(patch(), db());
        if (!wall) return;
        wall->decide(scalarField(this->size(), 0.0));
        vectorField& U = *this;
        U += inflow(*wall, patch());
    }
    void evaluate(const Pstream::commsTypes comms) override {
        ventilatedWallPressureFvPatchScalarField* wall = lettingGo(patch(), db());
        if (wall && wall->equations() != equations_) {  // until the end of the corrector phi is absolute
            equations_ = wall->equations();
            if (updated()) movingWallVelocityFvPatchVectorField::evaluate(comms);  // or the wall's would not be taken
            takeWall();
            vectorField& U = *this;
            wall->decide(U & patch().Sf());
            U += inflow(*wall, patch());
        }
        movingWallVelocityFvPatchVectorField::evaluate(comms);
    }
};

makePatchTypeField(fvPatchVectorField, ventilatedWallVelocityFvPatchVectorField);

/// The velocity of such a wall at rest that water slips along.
class ventilatedSlipFvPatchVectorField : public slipFvPatchField<vector> {
    void addInflow() {
        ventilatedWallPressureFvPatchScalarField* wall = lettingGo(patch(), db());
        if (!wall) return;
        wall->decide(scalarField(this->size(), 0.0));
        vectorField& U = *this;
        U += inflow(*wall, patch());
    }

public:
    TypeName("ventilatedSlip");

    ventilatedSlipFvPatchVectorField(const fvPatch& p, const DimensionedField<vector, volMesh>& field)
        : slipFvPatchField<vector>(p, field) {}
    ventilatedSlipFvPatchVectorField(const fvPatch& p, const DimensionedField<vector, volMesh>& field,
                                     const dictionary& dict)
        : slipFvPatchField<vector>(p, field, dict) {}
    ventilatedSlipFvPatchVectorField(const ventilatedSlipFvPatchVectorField& other, const fvPatch& p,
                                     const DimensionedField<vector, volMesh>& field, const released::Mapper& mapper)
        : slipFvPatchField<vector>(other, p, field, mapper) {}
    ventilatedSlipFvPatchVectorField(const ventilatedSlipFvPatchVectorField& other,
                                     const DimensionedField<vector, volMesh>& field)
        : slipFvPatchField<vector>(other, field) {}
    RELEASED_CLONES(ventilatedSlipFvPatchVectorField, vector)

    void updateCoeffs() override {
        if (updated()) return;
        slipFvPatchField<vector>::updateCoeffs();
        slipFvPatchField<vector>::evaluate(Pstream::commsTypes::blocking);
        addInflow();
        slipFvPatchField<vector>::updateCoeffs();  // evaluated, they would be asked for again
    }
    void evaluate(const Pstream::commsTypes comms) override {
        slipFvPatchField<vector>::evaluate(comms);
        addInflow();
    }
};

makePatchTypeField(fvPatchVectorField, ventilatedSlipFvPatchVectorField);

#endif

}  // namespace Foam
