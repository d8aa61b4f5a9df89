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
#include <Interface_Static.hxx>
#include <Standard_Failure.hxx>
#include <stdexcept>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <string>
#include <TDataStd_Name.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <utility>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include "meshes/read/cut_drawing.h"

namespace tw {
namespace {

constexpr double metres_per_unit = 1e-3;  // Open CASCADE turns every file's unit into millimetres

void open_with(auto& reader, const char* file, const char* kind) {
    if (reader.ReadFile(file) != IFSelect_RetDone)
        throw std::runtime_error(std::string("it is no ") + kind + " file, or a damaged one; export the hull again");
}

constexpr const char* no_shape = "nothing in it can be read as a shape; export the hull as a solid or as surfaces";

template <class Reader>
TopoDS_Shape shape_in(const char* file, const char* kind) {
    Reader reader;
    open_with(reader, file, kind);
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) throw std::runtime_error(no_shape);
    return shape;
}

/// A solid where its assembly places it; of a part that has none, all its faces.
struct PlacedSolid {
    TopoDS_Shape shape;
    std::vector<std::string> names;  ///< its own first, then outwards
};

/// Without what would not fit into a line.
std::string name_of(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (label.IsNull() || !label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
    std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()) + 1, '\0');
    Standard_PCharacter to = text.data();
    text.resize(static_cast<std::size_t>(name->Get().ToUTF8CString(to)));
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
    const auto first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The names with that of `label` before them.
std::vector<std::string> with_name_of(const TDF_Label& label, std::vector<std::string> names) {
    if (std::string name = name_of(label); !name.empty() && std::ranges::find(names, name) == names.end())
        names.insert(names.begin(), std::move(name));
    return names;
}

/// The solids below a label: an assembly's parts, each at its place in it, or the solids of a part.
void add_solids(const Handle(XCAFDoc_ShapeTool) & tool, const TDF_Label& label, const TopLoc_Location& place,
                const std::vector<std::string>& outer, std::vector<PlacedSolid>& to) {
    const std::vector<std::string> names = with_name_of(label, outer);
    if (TDF_Label part; XCAFDoc_ShapeTool::GetReferredShape(label, part))
        return add_solids(tool, part, place * XCAFDoc_ShapeTool::GetLocation(label), names, to);
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
        TDF_LabelSequence parts;
        XCAFDoc_ShapeTool::GetComponents(label, parts);
        for (const TDF_Label& part : parts) add_solids(tool, part, place, names, to);
        return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull()) return;
    TopExp_Explorer each(shape, TopAbs_SOLID);
    if (!each.More()) to.push_back({shape.Moved(place), names});
    for (; each.More(); each.Next()) {
        TDF_Label own;
        tool->FindSubShape(label, each.Current(), own);
        to.push_back({each.Current().Moved(place), with_name_of(own, names)});
    }
}

std::vector<PlacedSolid> solids_in(const char* file) {
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    STEPCAFControl_Reader reader;
    Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);  // also those of the solids of one part
    reader.SetColorMode(false);
    reader.SetLayerMode(false);
    reader.SetPropsMode(false);
    reader.SetGDTMode(false);
    reader.SetMatMode(false);
    reader.SetViewMode(false);
    open_with(reader, file, "STEP");
    if (!reader.Transfer(document)) throw std::runtime_error(no_shape);
    const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    TDF_LabelSequence roots;
    tool->GetFreeShapes(roots);
    std::vector<PlacedSolid> solids;
    for (const TDF_Label& root : roots) add_solids(tool, root, {}, {}, solids);
    return solids;
}

/// Null: no solid has this name.
TopoDS_Shape solids_called(const std::string& name, const char* file) {
    BRep_Builder builder;
    TopoDS_Compound named;
    for (const PlacedSolid& solid : solids_in(file)) {
        if (std::ranges::find(solid.names, name) == solid.names.end()) continue;
        if (named.IsNull()) builder.MakeCompound(named);
        builder.Add(named, solid.shape);
    }
    return named;
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

/// What Open CASCADE throws is not a std::exception.
void in_its_words(auto work) {
    try {
        work();
    } catch (const Standard_Failure& e) {
        throw std::runtime_error(std::string("Open CASCADE says: ") + e.GetMessageString());
    }
}

}  // namespace

extern "C" void tw_cut_drawing(const char* file, bool iges, double chord, double turn, const char* solid,
                               CutDrawing* to) {
    in_its_words([&] {
        const std::string name = solid;
        const TopoDS_Shape shape = !name.empty() ? solids_called(name, file)
                                   : iges        ? shape_in<IGESControl_Reader>(file, "IGES")
                                                 : shape_in<STEPControl_Reader>(file, "STEP");
        if (!shape.IsNull()) *to = triangles_of(shape, chord, turn);
    });
}

extern "C" void tw_name_solids(const char* file, std::vector<std::vector<std::string>>* to) {
    in_its_words([&] {
        for (PlacedSolid& solid : solids_in(file)) to->push_back(std::move(solid.names));
    });
}

}  // namespace tw
