// Signed-distance and inside queries per second round the stepped seaplane hull, on the points of a lattice as the
// particle set-up asks for them. Usage: bench_query [million points]
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/query.h"

int main(int argc, char** argv) {
    using namespace tw;
    const double millions = argc > 1 ? std::atof(argv[1]) : 10;
    const Surface hull = make_hull("seaplane", {});
    auto seconds = [since = std::chrono::steady_clock::now()]() mutable {
        const auto now = std::chrono::steady_clock::now();
        const double s = std::chrono::duration<double>(now - since).count();
        since = now;
        return s;
    };
    const SurfaceQuery query(hull);
    const double build = seconds();

    Box box = hull.bounds();
    box.min -= Vec3::Constant(1.0);
    box.max += Vec3::Constant(1.0);
    const double spacing = std::cbrt(box.volume() / (millions * 1e6));
    std::vector<Vec3> points;
    for (double x = box.min.x(); x < box.max.x(); x += spacing)
        for (double y = box.min.y(); y < box.max.y(); y += spacing)
            for (double z = box.min.z(); z < box.max.z(); z += spacing) points.emplace_back(x, y, z);
    std::vector<double> distance(points.size());

    std::printf("%zu triangles, tree %.3f s, %.3g million points, %d threads\n", hull.triangles.size(), build,
                1e-6 * points.size(), omp_get_max_threads());
    seconds();
    for (const double reach : {1e30, 4 * spacing}) {
        query.signed_distances(points, distance, reach);
        const double s = seconds();
        std::printf("signed distance, reach %-8.3g m: %6.2f s, %.2f us per query\n", reach, s, 1e6 * s / points.size());
    }
    const Surface sphere = make_hull("sphere", {{"level", 7}});
    seconds();
    const std::size_t findings = check_surface(sphere).size();
    std::printf("health check:                    %6.2f s for %zu triangles, %zu findings\n", seconds(),
                sphere.triangles.size(), findings);
    std::size_t inside = 0;
#pragma omp parallel for reduction(+ : inside)
    for (std::size_t i = 0; i < points.size(); ++i) inside += query.inside(points[i]);
    const double s = seconds();
    std::printf("inside:                          %6.2f s, %.2f us per query; volume %.2f m3\n", s,
                1e6 * s / points.size(), inside * spacing * spacing * spacing);
}
