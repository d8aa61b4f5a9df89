#include "structure/read_inp.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "base/errors.h"
#include "base/read_file.h"
#include "structure/mesh_builder.h"

namespace tw::structure {
namespace {

std::string upper(std::string_view s) {
    std::string out(s);
    for (char& c : out) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return out;
}

/// The fields between commas, without blanks.
std::vector<std::string> fields_of(std::string_view line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',')
            fields.emplace_back();
        else if (c != ' ' && c != '\t' && c != '\r')
            fields.back() += c;
    }
    if (fields.back().empty()) fields.pop_back();  // a line may end with a comma
    return fields;
}

class InpReader {
public:
    InpReader(const std::filesystem::path& file, double scale) : file_(file), scale_(scale), in_(file) {
        refuse_no_file(file);
        if (!in_) throw InputError(fmt::format("{}: cannot be read", file.string()));
    }

    MeshFile read() {
        std::string line;
        while (std::getline(in_, line)) {
            ++number_;
            if (line.starts_with("**")) continue;
            const std::vector<std::string> fields = fields_of(line);
            if (fields.empty()) continue;
            if (fields[0].starts_with('*'))
                keyword(fields);
            else if (keyword_ == "*NODE")
                node(fields);
            else if (keyword_ == "*ELEMENT")
                element(fields);
            else if (keyword_ == "*NSET")
                set(fields);
        }
        if (!pending_.empty())
            refuse(fmt::format("the last element has {} nodes; expected {}", pending_.size() - 1, corners_));
        if (!mesh_.has_elements()) refuse("no elements S4 or C3D8 in this file");
        return mesh_.finish();
    }

private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(fmt::format("{}:{}: {}", file_.string(), number_, why));
    }

    template <class Number>
    Number number(const std::string& field) const {
        Number value{};
        const char* from = field.data() + (field.starts_with('+') ? 1 : 0);
        const auto [end, error] = std::from_chars(from, field.data() + field.size(), value);
        if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(static_cast<double>(value)))
            refuse(fmt::format("\"{}\"; expected a number", field));
        return value;
    }

    void keyword(const std::vector<std::string>& fields) {
        if (!pending_.empty())
            refuse(fmt::format("an element of {} nodes; expected {}", pending_.size() - 1, corners_));
        keyword_ = upper(fields[0]);
        std::map<std::string, std::string> options;
        for (std::size_t k = 1; k < fields.size(); ++k) {
            const auto equals = fields[k].find('=');
            options[upper(fields[k].substr(0, equals))] =
                equals == std::string::npos ? "" : upper(fields[k].substr(equals + 1));
        }
        name_ = options[keyword_ == "*ELEMENT" ? "ELSET" : "NSET"];
        generate_ = options.contains("GENERATE");
        if (keyword_ == "*NSET" && name_.empty()) refuse("*NSET without a name");
        if (keyword_ != "*ELEMENT") return;
        const std::string& type = options["TYPE"];
        corners_ = type == "S4" || type == "S4R"                                             ? 4
                   : type == "C3D8" || type == "C3D8R" || type == "C3D8H" || type == "C3D8I" ? 8
                                                                                             : 0;
        if (corners_ == 0)
            refuse(fmt::format("elements of type \"{}\"; expected S4, S4R, C3D8, C3D8R, C3D8H or C3D8I", type));
    }

    void node(const std::vector<std::string>& fields) {
        if (fields.size() < 4)
            refuse(fmt::format("a node with {} fields; expected its number and three places", fields.size()));
        const int id = number<int>(fields[0]);
        Vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = scale_ * number<double>(fields[static_cast<std::size_t>(k + 1)]);
        if (!mesh_.add_node(id, p)) refuse(fmt::format("node {} is given twice", id));
        if (!name_.empty()) mesh_.set(name_).push_back(id);
    }

    void element(const std::vector<std::string>& fields) {
        for (const std::string& f : fields) pending_.push_back(number<int>(f));  // may go on over several lines
        if (static_cast<int>(pending_.size()) < corners_ + 1) return;
        if (static_cast<int>(pending_.size()) > corners_ + 1)
            refuse(fmt::format("an element of {} nodes; expected {}", pending_.size() - 1, corners_));
        for (std::size_t k = 1; k < pending_.size(); ++k)
            if (!mesh_.has_node(pending_[k]))
                refuse(fmt::format("element {}: node {} is not given above", pending_[0], pending_[k]));
        const auto corner = [&](std::size_t k) { return pending_[k + 1]; };
        if (corners_ == 4)
            mesh_.add_quad(pending_[0], {corner(0), corner(1), corner(2), corner(3)});
        else
            mesh_.add_hexahedron(
                pending_[0], {corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)},
                name_);
        pending_.clear();
    }

    void set(const std::vector<std::string>& fields) {
        auto& nodes = mesh_.set(name_);
        if (generate_) {
            if (fields.size() < 2) refuse("a generated set takes its first and last node and a step");
            const std::int64_t first = number<int>(fields[0]), last = number<int>(fields[1]),
                               step = fields.size() > 2 ? number<int>(fields[2]) : 1;
            if (step <= 0 || last < first || (last - first) / step > 100'000'000)
                refuse(fmt::format("nodes {} to {} in steps of {}", first, last, step));
            for (std::int64_t id = first; id <= last; id += step) into(nodes, static_cast<int>(id));
            return;
        }
        for (const std::string& f : fields) {
            if (const auto other = mesh_.sets().find(upper(f)); other != mesh_.sets().end() && other->first != name_)
                nodes.insert(nodes.end(), other->second.begin(), other->second.end());
            else
                into(nodes, number<int>(f));
        }
    }

    void into(std::vector<int>& nodes, int id) const {
        if (!mesh_.has_node(id)) refuse(fmt::format("set {}: node {} is not given above", name_, id));
        nodes.push_back(id);
    }

    std::filesystem::path file_;
    double scale_;
    std::ifstream in_;
    int number_ = 0;
    std::string keyword_, name_;
    bool generate_ = false;
    int corners_ = 0;
    std::vector<int> pending_;  // of the element that is being read
    MeshBuilder mesh_;
};
}  // namespace

MeshFile read_inp(const std::filesystem::path& file, double metres_per_unit) {
    return InpReader(file, metres_per_unit).read();
}

}  // namespace tw::structure
