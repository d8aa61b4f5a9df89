#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace tw {

/// A drawing as triangles.
struct CutDrawing {
    std::vector<double> points;         ///< x, y, z of each [m]
    std::vector<std::int64_t> corners;  ///< three a triangle, counter-clockwise seen from outside
};

/// Cuts a STEP or IGES file into triangles whose chords stay within `chord` times the diagonal of its box, and whose
/// neighbours' normals within `turn` [rad]. `solid`: of a STEP file the solids alone that have this name; empty: all.
/// Leaves nothing in `to` where none has it. Throws std::runtime_error that says why it cannot, without the file's name.
extern "C" void tw_cut_drawing(const char* file, bool iges, double chord, double turn, const char* solid,
                               CutDrawing* to);

/// The names of each solid of a STEP file (SolidNames of meshes/read/named_solid.h). Throws as above.
extern "C" void tw_name_solids(const char* file, std::vector<std::vector<std::string>>* to);

}  // namespace tw
