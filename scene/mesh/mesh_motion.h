#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// How the mesh of the mesh method follows a body that moves (docs/decisions/032-rigid-bodies.md).
struct MeshMotion {
    enum class Kind {
        none,      ///< nothing moves
        morphing,  ///< cells round the body move with it, those at walls and floor stay, between them cells are sheared
        sliding,   ///< all cells move up and down with the body, along the tank's sides; the floor is open
        open_water  ///< all cells move and turn with the body; every side is open to water at rest
    } kind = Kind::none;

    /// Morphing: cells nearer than `inner` to the body move with it, those farther than `outer` stay [m].
    double inner = 0, outer = 0;  ///< [m]
    /// Morphing: where cells take this share, 0 to 1, of the body's way, as OpenFOAM blends it [m]:
    ///
    ///   share = (1 - cos(pi (outer - r) / (outer - inner))) / 2
    double follows_by(double share) const;
    /// Morphing: how far any point of the body may move [m]. Cells fold at 2/pi of outer - inner (the blend is a
    /// cosine); the run is stopped at nine tenths of that.
    double stretch() const { return 0.57 * (outer - inner); }
    /// How far the body can come from where it starts, at most, as far as is known beforehand [m].
    double down = 0, up = 0, aside = 0;  ///< [m]

    bool whole_mesh() const { return kind == Kind::sliding || kind == Kind::open_water; }
    std::string sentence() const;  ///< for people: the technique and what it leaves out; empty where nothing moves
};

/// What the mesh follows: the scene's bodies, or, as a body named hull, a hull that is free.
std::vector<MovingBody> followed_by_mesh(const Scene& scene);

/// How the mesh follows: round a hull in a stream it is morphed. Of a body, by [fvm] body_mesh; with "auto" the mesh
/// is morphed where the body's way is known to be shorter than half of what lies between the body and the nearest wall,
/// because that keeps walls and floor; else it moves as a whole. Round several free bodies it is morphed within half of
/// the shortest distance between two of them. Throws InputError for what the mesh method cannot move: two free
/// rotations, a body too near to a wall or another body to morph the mesh between them, several bodies of which one is
/// prescribed or may come too far, a mesh that would move as a whole in a stream, obstacles or blocks of water beside
/// a mesh that moves as a whole, a prescribed turn that takes such a mesh's floor out of the water or its top under it.
MeshMotion mesh_motion(const Scene& scene);

}  // namespace tw
