#include "structure/read_mesh.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "structure/check_mesh.h"
#include "structure/read_inp.h"
#include "structure/read_msh.h"
#include "structure/read_vtu.h"

namespace tw::structure {

MeshFile read_mesh(const std::filesystem::path& file, double metres_per_unit) {
    const std::string ending = file.extension().string();
    if (ending != ".inp" && ending != ".msh" && ending != ".vtu")
        throw InputError(
            fmt::format("{}: a mesh of elements is read from .inp (Abaqus, CalculiX), .msh (Gmsh) and .vtu "
                        "(VTK) files; expected one of these endings",
                        file.string()));
    const MeshFile mesh = ending == ".inp"   ? read_inp(file, metres_per_unit)
                          : ending == ".msh" ? read_msh(file, metres_per_unit)
                                             : read_vtu(file, metres_per_unit);
    check_mesh(mesh, file);
    return mesh;
}

}  // namespace tw::structure
