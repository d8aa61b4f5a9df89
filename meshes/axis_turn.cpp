#include "meshes/axis_turn.h"

#include <cmath>
#include <Eigen/LU>
#include <string>
#include <utility>

#include "base/errors.h"

namespace tw {

Eigen::Matrix3d axis_turn(std::string_view axes) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
    int row = 0;
    double sign = 1;
    bool sound = true;
    for (const char c : axes) {
        if (c == '-' || c == '+') {
            sound = sound && row < 3;
            sign = c == '-' ? -1 : 1;
        } else if (c >= 'x' && c <= 'z' && row < 3) {
            turn(row++, c - 'x') = sign;
            sign = 1;
        } else {
            sound = false;
        }
    }
    if (!sound || row != 3 || std::abs(turn.determinant()) != 1)
        throw InputError(
            "axes \"" + std::string(axes) +
            "\": expected each of x, y and z once, with a sign, e.g. \"xyz\", \"x-zy\" (file with y up) or "
            "\"-x-yz\" (bow towards +x in the file)");
    return turn;
}

void turn_axes(Surface& surface, const Eigen::Matrix3d& turn) {
    for (Vec3& p : surface.points) p = turn * p;
    if (turn.determinant() < 0)
        for (auto& t : surface.triangles) std::swap(t[1], t[2]);
}

}  // namespace tw
