#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/atomic_file.h"

namespace tw::spray {

/// Three cubes of 1 m in a row along x, as an OpenFOAM case of text: full, a tenth full, and full again.
inline void write_row_of_cells(const std::filesystem::path& folder) {
    const auto foam = [](const char* kind, const std::string& name, const std::string& body) {
        return std::string("FoamFile { version 2.0; format ascii; class ") + kind + "; object " + name + "; }\n" + body;
    };
    const auto put = [&](const std::string& file, const std::string& text) {
        std::filesystem::create_directories((folder / file).parent_path());
        write_text_atomically(folder / file, text);
    };
    const auto list = [](const std::vector<std::string>& items) {
        std::string text = std::to_string(items.size()) + "\n(\n";
        for (const auto& item : items) text += item + "\n";
        return text + ")\n";
    };
    put("system/controlDict", foam("dictionary", "controlDict", "startTime 0; deltaT 1; writeInterval 1;\n"));
    std::vector<std::string> points;
    for (int i = 0; i < 4; ++i)
        for (const char* yz : {"0 0", "1 0", "1 1", "0 1"}) points.push_back("(" + std::to_string(i) + " " + yz + ")");
    std::vector<std::string> faces, owner;
    const auto face = [&](int a, int b, int c, int d, int cell) {
        faces.push_back("4(" + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
                        std::to_string(d) + ")");
        owner.push_back(std::to_string(cell));
    };
    face(4, 5, 6, 7, 0), face(8, 9, 10, 11, 1);  // between the cells
    face(0, 3, 2, 1, 0), face(12, 13, 14, 15, 2);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) face(4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k, i);
    put("constant/polyMesh/points", foam("vectorField", "points", list(points)));
    put("constant/polyMesh/faces", foam("faceList", "faces", list(faces)));
    put("constant/polyMesh/owner", foam("labelList", "owner", list(owner)));
    put("constant/polyMesh/neighbour", foam("labelList", "neighbour", list({"1", "2"})));
    put("constant/polyMesh/boundary",
        foam("polyBoundaryMesh", "boundary", "1\n(\nwalls { type wall; nFaces 14; startFace 2; }\n)\n"));
    const auto field = [&](const char* kind, const std::string& at, const std::string& name,
                           const std::string& values) {
        put(at + "/" + name, foam(kind, name,
                                  "dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform " + values +
                                      ";\nboundaryField { walls { type zeroGradient; } }\n"));
    };
    field("volVectorField", "0", "C", "List<vector> 3((0.5 0.5 0.5) (1.5 0.5 0.5) (2.5 0.5 0.5))");
    field("volScalarField", "0", "V", "List<scalar> 3(1 1 1)");
    field("volScalarField", "1", "alpha.water", "List<scalar> 3(1 0.1 1)");
    field("volVectorField", "1", "U", "List<vector> 3((1 0 0) (2 0 0) (3 0 4))");
}

}  // namespace tw::spray
