#pragma once
#include <cstdint>
#include <vector>

namespace tw {

/// A drawing as triangles.
struct CutDrawing {
    std::vector<double> points;         ///< x, y, z of each [m]
    std::vector<std::int64_t> corners;  ///< three a triangle, counter-clockwise seen from outside
};

/// Cuts a STEP or IGES file into triangles whose chords stay within `chord` times the diagonal of its box, and whose
/// neighbours' normals within `turn` [rad]. Throws std::runtime_error that says why it cannot, without the file's name.
extern "C" void tw_cut_drawing(const char* file, bool iges, double chord, double turn, CutDrawing* to);

}  // namespace tw
