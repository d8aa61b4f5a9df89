#include "meshes/read/cad.h"

#ifdef TWINWAKE_OCCT
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
#include <vtkCellArray.h>
#include <vtkPoints.h>
#endif

#include <numbers>
#include <string>

#include "base/errors.h"
#include "meshes/read/vtk_arrays.h"

namespace tw {

#ifdef TWINWAKE_OCCT
namespace {

constexpr double metres_per_unit = 1e-3;  // Open CASCADE turns every file's unit into millimetres

template <class Reader>
TopoDS_Shape shape_in(const std::filesystem::path& readable, const char* kind) {
    Reader reader;
    if (reader.ReadFile(readable.c_str()) != IFSelect_RetDone)
        throw InputError(std::string("it is no ") + kind + " file, or a damaged one; export the hull again");
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull())
        throw InputError("nothing in it can be read as a shape; export the hull as a solid or as surfaces");
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
    if (box.IsVoid()) throw InputError("it holds no faces; export the hull as a solid or as surfaces");
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

vtkSmartPointer<vtkPointSet> triangles_of(const TopoDS_Shape& drawing) {
    const double diagonal = diagonal_of(drawing);
    const TopoDS_Shape body = body_of(drawing, diagonal);
    BRepMesh_IncrementalMesh(body, cad_chord * diagonal, false, 12 * std::numbers::pi / 180);
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto triangles = vtkSmartPointer<vtkCellArray>::New();
    points->SetDataTypeToDouble();
    int faces = 0, cut = 0;
    for (TopExp_Explorer each(body, TopAbs_FACE); each.More(); each.Next(), ++faces) {
        const TopoDS_Face& face = TopoDS::Face(each.Current());
        TopLoc_Location place;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
        if (mesh.IsNull()) continue;
        ++cut;
        const vtkIdType first = points->GetNumberOfPoints();
        for (int n = 1; n <= mesh->NbNodes(); ++n) {
            const gp_Pnt p = mesh->Node(n).Transformed(place.Transformation());
            points->InsertNextPoint(metres_per_unit * p.X(), metres_per_unit * p.Y(), metres_per_unit * p.Z());
        }
        const bool turned = (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
        for (int t = 1; t <= mesh->NbTriangles(); ++t) {
            int a = 0, b = 0, c = 0;
            mesh->Triangle(t).Get(a, b, c);
            const vtkIdType corners[] = {first + a - 1, first + (turned ? c : b) - 1, first + (turned ? b : c) - 1};
            triangles->InsertNextCell(3, corners);
        }
    }
    if (faces == 0) throw InputError("it holds no faces; export the hull as a solid or as surfaces");
    if (cut < faces)
        throw InputError(std::to_string(faces - cut) + " of its " + std::to_string(faces) +
                         " faces cannot be cut into triangles; mend the drawing, or export a mesh (STL)");
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    return surface;
}

}  // namespace

bool reads_cad() { return true; }

vtkSmartPointer<vtkPolyData> read_cad(const std::filesystem::path& file, const std::filesystem::path& readable, bool iges) {
    const auto read = [&]() -> vtkSmartPointer<vtkPointSet> {
        try {
            return triangles_of(iges ? shape_in<IGESControl_Reader>(readable, "IGES")
                                     : shape_in<STEPControl_Reader>(readable, "STEP"));
        } catch (const Standard_Failure& e) {  // not a std::exception
            throw InputError(std::string("Open CASCADE says: ") + e.GetMessageString());
        }
    };
    try {
        return surface_of(read_by_vtk(read, true));
    } catch (const InputError& e) { throw InputError(file.string() + ": cannot be read: " + e.what()); }
}

#else

bool reads_cad() { return false; }

vtkSmartPointer<vtkPolyData> read_cad(const std::filesystem::path& file, const std::filesystem::path&, bool) {
    throw InputError(file.string() +
                     ": this program was built without Open CASCADE, which reads STEP and IGES; export the hull as STL, "
                     "or install libocct-data-exchange-dev and build again");
}

#endif

}  // namespace tw
