#pragma once
#include <string>
#include <vector>

#include "meshes/generate.h"
#include "meshes/health.h"

namespace tw {

// Sound surfaces made unsound in one way each.

inline Surface shifted(Surface s, const Vec3& by) {
    for (Vec3& p : s.points) p += by;
    return s;
}
inline Surface scaled(Surface s, double by) {
    for (Vec3& p : s.points) p *= by;
    return s;
}
inline Surface turned_inside_out(Surface s) {
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}
inline Surface together(Surface a, const Surface& b) {
    const int n = static_cast<int>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    return a;
}

inline const Finding* finding(const std::vector<Finding>& findings, const std::string& name) {
    for (const Finding& f : findings)
        if (f.name == name) return &f;
    return nullptr;
}
inline std::string names(const std::vector<Finding>& findings) {
    std::string all;
    for (const Finding& f : findings) all += (all.empty() ? "" : " ") + f.name;
    return all;
}

}  // namespace tw
