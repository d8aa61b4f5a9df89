#include "foam_cases/files/case_files.h"
#include "scene/mesh/mesh_cells.h"

namespace tw {

/// system/surfaceFeatureExtractDict: keels, chines and other edges sharper than 30 degrees, for snapping.
std::string surface_features_dict(const CasePlan& plan) {
    Dictionary entries;
    const Dictionary subset{{"nonManifoldEdges", false}, {"openEdges", true}};
    if (plan.flavour.features_per_surface()) {
        for (const Solid& s : plan.solids)
            entries.add(s.name + ".stl", Dictionary{{"extractionMethod", Word("extractFromSurface")},
                                                    {"extractFromSurfaceCoeffs", Dictionary{{"includedAngle", 150}}},
                                                    {"includedAngle", 150},
                                                    {"subsetFeatures", subset},
                                                    {"writeObj", false}});
    } else {
        List surfaces;
        for (const Solid& s : plan.solids) surfaces.push_back(Quoted(s.name + ".stl"));
        entries = {{"surfaces", surfaces}, {"includedAngle", 150}, {"subsetFeatures", subset}};
    }
    return foam_file("dictionary", plan.flavour.surface_features_program() + "Dict", entries);
}

namespace {

/// snappyHexMesh's own limits of mesh quality, without those of tetrahedra, twist and concavity: they made it give up
/// the snapping at sharp keels and transoms, which cut off up to a third of a cell there (decision 028). checkMesh finds
/// the meshes sound.
Dictionary mesh_quality() {
    return {{"maxNonOrtho", 65},
            {"maxBoundarySkewness", 20},
            {"maxInternalSkewness", 4},
            {"maxConcave", 180},
            {"minVol", 1e-13},
            {"minTetQuality", -1e30},
            {"minArea", -1},
            {"minTwist", -1},
            {"minDeterminant", 0.001},
            {"minFaceWeight", 0.05},
            {"minVolRatio", 0.02},
            {"minTriangleTwist", -1},
            {"nSmoothScale", 4},
            {"errorReduction", 0.75},
            {"relaxed", Dictionary{{"maxNonOrtho", 75}}}};
}

/// snappyHexMesh wants this dictionary even where no layers are added.
Dictionary no_layers() {
    return {{"relativeSizes", true},
            {"layers", Dictionary{}},
            {"expansionRatio", 1.5},
            {"finalLayerThickness", 0.5},
            {"minThickness", 0.05},
            {"nGrow", 0},
            {"featureAngle", 130},
            {"nRelaxIter", 5},
            {"nSmoothSurfaceNormals", 1},
            {"nSmoothNormals", 3},
            {"nSmoothThickness", 10},
            {"maxFaceThicknessRatio", 0.5},
            {"maxThicknessToMedialRatio", 0.5},
            {"minMedianAxisAngle", 90},
            {"minMedialAxisAngle", 90},
            {"nBufferCellsNoExtrude", 0},
            {"nLayerIter", 50},
            {"nRelaxedIter", 20}};
}

}  // namespace

/// system/snappyHexMeshDict: refinement in the scene's boxes, solids cut out and snapped to. No prism layers: air
/// smeared by the interface scheme collects in them and halves the friction (measured).
std::string snappy_hex_mesh_dict(const CasePlan& plan) {
    Dictionary geometry, surfaces, regions;
    List features;
    // openfoam.org 12 wants the file; others take it from the name of the entry, and allow this as well
    const auto surface_of = [](const std::string& name) {
        return Dictionary{{"type", Word("triSurfaceMesh")}, {"file", Quoted(name + ".stl")}, {"name", Word(name)}};
    };
    for (const Solid& s : plan.solids) {
        const int level = s.is_hull ? plan.surface_level : std::max(plan.surface_level, plan.wet_level);
        geometry.add(s.name + ".stl", surface_of(s.name));
        features.push_back(
            Dictionary{{"file", Quoted(s.name + ".eMesh")}, {"level", s.is_hull ? plan.feature_level : level}});
        surfaces.add(s.name,
                     Dictionary{{"level", List{level, level}}, {"patchInfo", Dictionary{{"type", Word("wall")}}}});
    }
    for (const RefinementBox& b : plan.boxes) {
        geometry.add(b.name, Dictionary{{"type", Word("searchableBox")}, {"min", b.box.min}, {"max", b.box.max}});
        Dictionary region{{"mode", Word("inside")}};
        if (plan.flavour.distance_in_box_level()) region.add("level", List{1e15, b.level});
        regions.add(b.name, region.add("levels", List{List{1e15, b.level}}));
    }
    if (!plan.ribbon.empty()) {
        const List near{List{plan.shedding.reach, plan.wet_level + plan.shedding.halvings}};
        geometry.add(plan.ribbon + ".stl", surface_of(plan.ribbon));
        regions.add(plan.ribbon, Dictionary{{"mode", Word("distance")}, {"levels", near}});
    }
    const Dictionary castellation{{"maxLocalCells", 100000000},
                                  {"maxGlobalCells", 200000000},
                                  {"minRefinementCells", 0},
                                  {"maxLoadUnbalance", 0.1},
                                  {"nCellsBetweenLevels", cells_between_levels},
                                  {"features", features},
                                  {"refinementSurfaces", surfaces},
                                  {"resolveFeatureAngle", 30},
                                  {"refinementRegions", regions},
                                  {"locationInMesh", plan.point_in_fluid},
                                  {"allowFreeStandingZoneFaces", true}};
    // Smoothing the surface before it is snapped draws points off the edges: with none a transom's edge is met best
    // (docs/decisions/028-shedding-edges.md). Sections keep it: it makes their cells rounder, and their edges are met.
    const int smoothing = plan.extrude ? 3 : 0;
    const Dictionary snapping{{"nSmoothPatch", smoothing},
                              {"tolerance", 2.0},
                              {"nSolveIter", 50},
                              {"nRelaxIter", 5},
                              {"nFeatureSnapIter", 10},
                              {"implicitFeatureSnap", false},
                              {"explicitFeatureSnap", true},
                              {"multiRegionFeatureSnap", false}};
    return foam_file("dictionary", "snappyHexMeshDict",
                     {{"castellatedMesh", true},
                      {"snap", !plan.solids.empty()},
                      {"addLayers", false},
                      {"geometry", geometry},
                      {"castellatedMeshControls", castellation},
                      {"snapControls", snapping},
                      {"addLayersControls", no_layers()},
                      {"meshQualityControls", mesh_quality()},
                      {"debug", 0},
                      {"mergeTolerance", 1e-6}});
}

}  // namespace tw
