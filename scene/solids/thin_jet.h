#pragma once
#include <optional>

#include "record/spray_jet.h"
#include "scene/scene.h"

namespace tw {

/// The jet that the hull throws in its stream, by thin-jet theory, without gravity:
///
///   a bottom with deadrise beta    delta = c tan^2(beta)/(2 pi)            Wagner 1932, ZAMM 12, 193
///   a flat one of trim tau         delta = pi l tau^2/(4 + 2 pi tau)       Green 1936, Proc. Camb. Phil. Soc. 32, 67
///
/// c: half breadth up to which the risen water reaches, pi/2 of the half breadth at still water and at most the chine's;
/// a cross section of the stream meets the bottom as still water meets a wedge that enters it, and delta does not depend
/// on how fast; both sides of every keel, wherever it lies. beta: of the chord from the keel to there. l: wetted length. A bottom counts as flat where its stagnation
/// line runs across rather than along it, tan(beta) < (pi/2) tan(tau) (Savitsky 1964). The thickest along the hull; an
/// estimate, better the smaller the angles are. None: no hull in a stream, a hull that does not break the surface, or one
/// without trim and deadrise.
///
/// A section with a flat bottom has the exact thickness of the free streamlines in a channel of its box's depth
/// (record/planing_plate.h); with another bottom, none is known.
std::optional<SprayJet> thin_jet(const Scene& scene);

}  // namespace tw
