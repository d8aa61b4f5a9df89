#include "foam_cases/files/case_files.h"

namespace tw {

// A flat mesh with refined cells. snappyHexMesh halves cells in all directions, so it is given a slab whose front and back
// are symmetry planes; one layer of cells is then drawn out of the slab's front, and its sides become `empty`.

std::string slab_side(const Patch& patch) { return patch.name + "OfSlab"; }

/// system/extrudeMeshDict: the front of the slab, through the thickness of the scene.
std::string extrude_mesh_dict(const CasePlan& plan) {
    const Box& box = plan.scene->domain.box;
    return foam_file(
        "dictionary", "extrudeMeshDict",
        {{"constructFrom", Word("patch")},
         {"sourceCase", Quoted("$FOAM_CASE")},
         {"sourcePatches", List{Word(slab_side(plan.sides[2]))}},
         {"exposedPatchName", Word(slab_side(plan.sides[3]))},
         {"flipNormals", true},  // the layer lies inside the slab, against the front's outward normal
         {"extrudeModel", Word("linearDirection")},
         {"nLayers", 1},
         {"expansionRatio", 1},
         {"linearDirectionCoeffs", Dictionary{{"direction", Vec3(0, 1, 0)}, {"thickness", box.size().y()}}},
         {"mergeFaces", false},
         {"mergeTol", 0}});
}

/// system/createPatchDict: front and back of the layer under their own names.
std::string create_patch_dict(const CasePlan& plan) {
    List patches;
    for (const std::size_t side : {2u, 3u})
        patches.push_back(Dictionary{{"name", Word(plan.sides[side].name)},
                                     {"patchInfo", Dictionary{{"type", Word("empty")}}},
                                     {"constructFrom", Word("patches")},
                                     {"patches", List{Word(slab_side(plan.sides[side]))}}});
    return foam_file("dictionary", "createPatchDict", {{"pointSync", false}, {"patches", patches}});
}

void add_sides_of_slab(const CasePlan& plan, Dictionary& boundary) {
    if (!plan.extrude || !plan.flavour.keeps_planes_without_faces()) return;
    for (const std::size_t side : {2u, 3u})
        boundary.add(slab_side(plan.sides[side]), Dictionary{{"type", Word("symmetryPlane")}});
}

}  // namespace tw
