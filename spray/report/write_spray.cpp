#include "spray/report/write_spray.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <iterator>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/snapshot.h"

namespace tw::spray {
namespace fs = std::filesystem;
namespace {

std::string droplets_csv(const SprayResult& r) {
    std::string out =
        "x [m],y [m],z [m],u [m/s],v [m/s],w [m/s],diameter [m],time [s],end,target,end time [s],end x [m],end y [m],"
        "end z [m],end u [m/s],end v [m/s],end w [m/s],normal speed [m/s],angle [rad]\n";
    auto to = std::back_inserter(out);
    for (std::size_t i = 0; i < r.droplets.size(); ++i) {
        const Droplet& d = r.droplets[i];
        const Landing& l = r.landings[i];
        fmt::format_to(to, "{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{},", d.place.x(), d.place.y(),
                       d.place.z(), d.velocity.x(), d.velocity.y(), d.velocity.z(), d.diameter, d.time,
                       to_string(l.fate),
                       l.target < 0 ? "" : csv_cell(r.target_names[static_cast<std::size_t>(l.target)]));
        fmt::format_to(to, "{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", l.time, l.place.x(),
                       l.place.y(), l.place.z(), l.velocity.x(), l.velocity.y(), l.velocity.z(), l.normal_speed,
                       l.angle);
    }
    return out;
}

/// Points with fields as .vtp.
void write_points(const fs::path& file, const std::vector<Vec3>& places, const std::vector<Field>& fields) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
    vtkNew<vtkCellArray> vertices;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto id = static_cast<vtkIdType>(i);
        points->SetPoint(id, places[i].data());
        vertices->InsertNextCell(1, &id);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    for (const Field& f : fields) {
        vtkNew<vtkFloatArray> array;
        array->SetName(f.name.c_str());
        array->SetNumberOfComponents(f.components);
        array->SetNumberOfTuples(static_cast<vtkIdType>(places.size()));
        std::copy(f.values.begin(), f.values.end(), array->GetPointer(0));
        data->GetPointData()->AddArray(array);
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToBinary();
    writer->SetWriteToOutputString(true);
    if (!writer->Write()) throw RunError(file.string() + ": the droplets cannot be turned into a .vtp file");
    write_text_atomically(file, writer->GetOutputString());
}

void write_vtp(const fs::path& folder, const SprayResult& r) {
    std::vector<Vec3> starts, ends;
    Field velocity{"velocity", 3, {}}, landing{"velocity", 3, {}}, diameter{"diameter", 1, {}}, time{"time", 1, {}},
        end_time{"time", 1, {}}, fate{"end", 1, {}}, target{"target", 1, {}}, normal_speed{"normal_speed", 1, {}};
    const auto push = [](Field& f, const Vec3& v) {
        for (int k = 0; k < 3; ++k) f.values.push_back(static_cast<float>(v[k]));
    };
    for (std::size_t i = 0; i < r.droplets.size(); ++i) {
        const Droplet& d = r.droplets[i];
        const Landing& l = r.landings[i];
        starts.push_back(d.place), ends.push_back(l.place);
        push(velocity, d.velocity), push(landing, l.velocity);
        diameter.values.push_back(static_cast<float>(d.diameter));
        time.values.push_back(static_cast<float>(d.time)), end_time.values.push_back(static_cast<float>(l.time));
        fate.values.push_back(static_cast<float>(l.fate)), target.values.push_back(static_cast<float>(l.target));
        normal_speed.values.push_back(static_cast<float>(l.normal_speed));
    }
    write_points(folder / "droplets.vtp", starts, {velocity, diameter, time});
    write_points(folder / "landings.vtp", ends, {landing, diameter, end_time, fate, target, normal_speed});
}

std::string curve_csv(const LoadCurve& curve) {
    std::string out = "time [s],pressure [Pa]\n";
    for (std::size_t k = 0; k < curve.pressure.size(); ++k)
        out +=
            fmt::format("{:.9g},{:.9g}\n", curve.from + (static_cast<double>(k) + 0.5) * curve.step, curve.pressure[k]);
    return out;
}

}  // namespace

void write_spray(const fs::path& folder, const SprayStudy& study, const SprayResult& r) {
    write_text_atomically(folder / "droplets.csv", droplets_csv(r));
    write_vtp(folder, r);
    for (const ReportTable& t : spray_tables(study, r))
        for (auto [title, file] : {std::pair{"Ledger of the water", "ledger.csv"},
                                   {"Where the droplets went", "ends.csv"},
                                   {"Load in time", "windows.csv"},
                                   {"Two sprays", "two_sprays.csv"},
                                   {"Speed that the way to a surface asks for", "reach.csv"},
                                   {"Against the measurement", "measured.csv"},
                                   {"A small face, hit by one droplet at a time", "face.csv"},
                                   {"Convergence over the window's area", "by_area.csv"},
                                   {"Convergence over the window's length", "by_length.csv"}})
            if (t.title == title) write_text_atomically(folder / file, csv_of(t));
    if (!r.curve.pressure.empty()) write_text_atomically(folder / "load.csv", curve_csv(r.curve));
    write_text_atomically(folder / "report.html", spray_html(study, r));
}

}  // namespace tw::spray
