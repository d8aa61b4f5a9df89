#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "meshes/read/gzip.h"

namespace tw {

/// A surface file of a known kind that holds something.
struct OpenedSurface {
    std::string type;                    ///< .stl, .obj, .ply, .vtp, .step, .stp, .igs or .iges
    std::string content;                 ///< unpacked, without a byte order mark
    std::filesystem::path readable;      ///< a file with this content: the file itself, or that of `memory`
    std::unique_ptr<MemoryFile> memory;  ///< where the content is not the file's own

    bool step() const { return type == ".stp" || type == ".step"; }
    bool iges() const { return type == ".igs" || type == ".iges"; }
    bool drawing() const { return step() || iges(); }
    bool names_solids() const;  ///< STEP, OBJ and ascii STL
    void go_on_with(std::string other);
};
/// Throws InputError naming the file: missing, of unknown kind, empty, larger than 4 GB, damaged where it is
/// compressed, or UTF-16.
OpenedSurface opened_surface(const std::filesystem::path& file);

}  // namespace tw
