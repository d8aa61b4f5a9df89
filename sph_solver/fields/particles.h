#pragma once
#include <cstdint>

#include "sph_solver/fields/field_list.h"
#include "sph_solver/fields/field_table.h"

namespace tw {

/// The particles of a level, structure of arrays, kept sorted in space: the quantities of field_list.h.
struct Particles : FieldTable {
#define TW_FIELD(Type, name, law, kept, with) FieldOf<Type, Law::law> name{*this, #name, Kept::kept, With::with};
    TW_PARTICLE_FIELDS(TW_FIELD)
#undef TW_FIELD
    Marks surface{*this, "surface", Kept::sorted};  ///< those at the free surface

    std::size_t size() const { return x.size(); }

    void add(double px, double py, double pz, float pu, float pdrho, std::int64_t pid, Kind pkind) {
        const std::size_t i = grow();
        x[i] = px, y[i] = py, z[i] = pz;
        u[i] = pu, drho[i] = pdrho, id[i] = pid, kind[i] = pkind;
    }
    /// Where they are; null: the level's particles have none.
    FieldsView view() {
        FieldsView all;
        FieldsView::each(*this, all,
                         [](auto& field, auto& pointer, auto) { pointer = field.empty() ? nullptr : field.data(); });
        return all;
    }
};

}  // namespace tw
