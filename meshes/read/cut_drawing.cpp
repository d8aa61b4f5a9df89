// Drawings by Open CASCADE: a library of its own, loaded where a drawing is read, because linked into the program Open
// CASCADE would add a tenth of a second to each of its starts.
#include <algorithm>
#include <Bnd_Box.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <cmath>
#include <IGESControl_Reader.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Standard_Failure.hxx>
#include <stdexcept>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <STEPControl_Reader.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_ShapeRepresentationRelationshipWithTransformation.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <string>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <vector>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "meshes/read/cut_drawing.h"
#include "meshes/read/named_solid.h"

namespace tw {
namespace {

constexpr double metres_per_unit = 1e-3;  // Open CASCADE turns every file's unit into millimetres

template <class Reader>
TopoDS_Shape shape_in(Reader& reader, const char* file, const char* kind) {
    if (reader.ReadFile(file) != IFSelect_RetDone)
        throw std::runtime_error(std::string("it is no ") + kind + " file, or a damaged one; export the hull again");
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull())
        throw std::runtime_error("nothing in it can be read as a shape; export the hull as a solid or as surfaces");
    return shape;
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum what) {
    int n = 0;
    for (TopExp_Explorer each(shape, what); each.More(); each.Next()) ++n;
    return n;
}

double diagonal_of(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    if (box.IsVoid()) throw std::runtime_error("it holds no faces; export the hull as a solid or as surfaces");
    return std::sqrt(box.SquareExtent());
}

/// The solids in it; where there is none, its faces, sewn, with normals outward where they enclose something.
TopoDS_Shape body_of(const TopoDS_Shape& shape, double diagonal) {
    BRep_Builder builder;
    TopoDS_Compound body;
    builder.MakeCompound(body);
    if (count_of(shape, TopAbs_SOLID) > 0) {
        for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) builder.Add(body, each.Current());
        return body;
    }
    BRepBuilderAPI_Sewing sewing(1e-5 * diagonal);
    sewing.Add(shape);
    sewing.Perform();
    const TopoDS_Shape sewn = sewing.SewedShape();
    for (TopExp_Explorer each(sewn, TopAbs_SHELL); each.More(); each.Next()) {
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, each.Current());
        if (BRep_Tool::IsClosed(each.Current())) BRepLib::OrientClosedSolid(solid);
        builder.Add(body, solid);
    }
    for (TopExp_Explorer each(sewn, TopAbs_FACE, TopAbs_SHELL); each.More(); each.Next())
        builder.Add(body, each.Current());
    return body;
}

/// The product whose representation an entity of a STEP file belongs to: upwards to the nearest representation that
/// defines a product's shape, but not from a part to the assembly that places it. Empty: none is found.
std::string product_of(const Handle(Standard_Transient) & entity, const Interface_Graph& graph) {
    std::vector<Handle(Standard_Transient)> level{entity}, seen;
    constexpr int farthest = 8;
    for (int step = 0; step < farthest && !level.empty(); ++step) {
        std::vector<Handle(Standard_Transient)> next;
        for (const auto& e : level) {
            Interface_EntityIterator above = graph.Sharings(e);
            for (above.Start(); above.More(); above.Next()) {
                const Handle(Standard_Transient)& who = above.Value();
                if (std::find(seen.begin(), seen.end(), who) != seen.end()) continue;
                seen.push_back(who);
                const auto shape = Handle(StepShape_ShapeDefinitionRepresentation)::DownCast(who);
                if (!shape.IsNull()) {
                    const auto property = shape->Definition().PropertyDefinition();
                    const auto product = property.IsNull() ? nullptr : property->Definition().ProductDefinition();
                    if (!product.IsNull()) return product->Formation()->OfProduct()->Name()->ToCString();
                }
                if (who->IsKind(STANDARD_TYPE(StepRepr_ShapeRepresentationRelationshipWithTransformation))) continue;
                const auto relation = Handle(StepRepr_RepresentationRelationship)::DownCast(who);
                if (!relation.IsNull()) next.push_back(relation->Rep1()), next.push_back(relation->Rep2());
                if (who->IsKind(STANDARD_TYPE(StepRepr_Representation))) next.push_back(who);
            }
        }
        level = std::move(next);
    }
    return {};
}

/// The solids that a STEP file calls so, by their product (a body of FreeCAD is one) or by themselves.
TopoDS_Shape solids_called(const std::string& name, const STEPControl_Reader& reader, const TopoDS_Shape& shape) {
    const Handle(XSControl_TransferReader) transfer = reader.WS()->TransferReader();
    const Interface_Graph graph = reader.WS()->Graph();
    BRep_Builder builder;
    TopoDS_Compound named;
    builder.MakeCompound(named);
    std::vector<std::string> there;
    int found = 0;
    for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) {
        Handle(Standard_Transient) entity = transfer->EntityFromShapeResult(each.Current(), 1);
        if (entity.IsNull()) entity = transfer->EntityFromShapeResult(each.Current().Located(TopLoc_Location()), 1);
        if (entity.IsNull()) continue;
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
        const std::string own = item.IsNull() || item->Name().IsNull() ? "" : item->Name()->ToCString();
        const std::string product = product_of(entity, graph);
        for (const std::string& n : {product, own})
            if (!n.empty() && std::find(there.begin(), there.end(), n) == there.end()) there.push_back(n);
        if (name != own && name != product) continue;
        builder.Add(named, each.Current());
        ++found;
    }
    if (found == 0) throw std::runtime_error(no_such_solid(name, there));
    return named;
}

CutDrawing triangles_of(const TopoDS_Shape& drawing, double chord, double turn) {
    const double diagonal = diagonal_of(drawing);
    const TopoDS_Shape body = body_of(drawing, diagonal);
    BRepMesh_IncrementalMesh(body, chord * diagonal, false, turn);
    CutDrawing cut;
    int faces = 0, done = 0;
    for (TopExp_Explorer each(body, TopAbs_FACE); each.More(); each.Next(), ++faces) {
        const TopoDS_Face& face = TopoDS::Face(each.Current());
        TopLoc_Location place;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
        if (mesh.IsNull()) continue;
        ++done;
        const auto first = static_cast<std::int64_t>(cut.points.size() / 3);
        for (int n = 1; n <= mesh->NbNodes(); ++n) {
            const gp_Pnt p = mesh->Node(n).Transformed(place.Transformation());
            for (const double x : {p.X(), p.Y(), p.Z()}) cut.points.push_back(metres_per_unit * x);
        }
        const bool turned = (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
        for (int t = 1; t <= mesh->NbTriangles(); ++t) {
            int a = 0, b = 0, c = 0;
            mesh->Triangle(t).Get(a, b, c);
            for (const int corner : {a, turned ? c : b, turned ? b : c}) cut.corners.push_back(first + corner - 1);
        }
    }
    if (faces == 0) throw std::runtime_error("it holds no faces; export the hull as a solid or as surfaces");
    if (done < faces)
        throw std::runtime_error(std::to_string(faces - done) + " of its " + std::to_string(faces) +
                                 " faces cannot be cut into triangles; mend the drawing, or export a mesh (STL)");
    return cut;
}

}  // namespace

extern "C" void tw_cut_drawing(const char* file, bool iges, double chord, double turn, const char* name,
                               CutDrawing* to) {
    try {
        if (iges && *name != '\0')
            throw std::runtime_error(
                "solids are taken by name from STEP, STL and OBJ files; export the bodies as STEP");
        IGESControl_Reader iges_reader;
        STEPControl_Reader step_reader;
        TopoDS_Shape shape = iges ? shape_in(iges_reader, file, "IGES") : shape_in(step_reader, file, "STEP");
        if (*name != '\0') shape = solids_called(name, step_reader, shape);
        *to = triangles_of(shape, chord, turn);
    } catch (const Standard_Failure& e) {  // not a std::exception
        throw std::runtime_error(std::string("Open CASCADE says: ") + e.GetMessageString());
    }
}

}  // namespace tw
