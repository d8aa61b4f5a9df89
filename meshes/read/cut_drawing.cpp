// Drawings by Open CASCADE: a library of its own, loaded where a drawing is read, because linked into the program Open
// CASCADE would add a tenth of a second to each of its starts.
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <stdexcept>
#include <string>

#include "meshes/read/cut_drawing.h"

namespace tw {
namespace {

constexpr double metres_per_unit = 1e-3;  // Open CASCADE turns every file's unit into millimetres

template <class Reader>
TopoDS_Shape shape_in(const char* file, const char* kind) {
    Reader reader;
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

extern "C" void tw_cut_drawing(const char* file, bool iges, double chord, double turn, CutDrawing* to) {
    try {
        *to =
            triangles_of(iges ? shape_in<IGESControl_Reader>(file, "IGES") : shape_in<STEPControl_Reader>(file, "STEP"),
                         chord, turn);
    } catch (const Standard_Failure& e) {  // not a std::exception
        throw std::runtime_error(std::string("Open CASCADE says: ") + e.GetMessageString());
    }
}

}  // namespace tw
