#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "record/hdf5_file.h"
#include "sph_solver/fields/field_table.h"

/// Names and types of the checkpoint's file (checkpoint.h), for its writer and its reader.
namespace tw::checkpoint_layout {

inline constexpr double version = 3;  // 2: without the checksum line
inline constexpr const char* bodies_group = "bodies";
/// Splits and merges at the edge between levels k and k + 1.
inline std::string edge_name(std::size_t k) { return fmt::format("edge_{}", k); }

inline hid_t type_of(const AnyField& field) {
    switch (field.element()) {
        case AnyField::Element::float64: return H5T_NATIVE_DOUBLE;
        case AnyField::Element::float32: return H5T_NATIVE_FLOAT;
        case AnyField::Element::int64: return H5T_NATIVE_INT64;
        case AnyField::Element::uint8: return H5T_NATIVE_UINT8;
        case AnyField::Element::packed: break;
    }
    throw std::logic_error(std::string(field.name()) + ": checkpoints hold numbers only");
}

}  // namespace tw::checkpoint_layout
