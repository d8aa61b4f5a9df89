#include "structure/read_inp.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

#include "base/errors.h"

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

class Reader {
public:
    Reader(const std::filesystem::path& file, double scale) : file_(file), scale_(scale), in_(file) {
        if (!in_) throw InputError(fmt::format("{}: cannot be read", file.string()));
    }

    InpMesh read() {
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
        if (quads_.empty() && hexahedra_.empty()) refuse("no elements S4 or C3D8 in this file");
        InpMesh mesh;
        mesh.shell.quads = used(quads_, mesh.shell.nodes, mesh.shell.sets);
        mesh.solid.hexahedra = used(hexahedra_, mesh.solid.nodes, mesh.solid.sets);
        mesh.solid.material = material_;
        mesh.materials = materials_;
        return mesh;
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
        if (!nodes_.emplace(id, p).second) refuse(fmt::format("node {} is given twice", id));
        if (!name_.empty()) sets_[name_].push_back(id);
    }

    void element(const std::vector<std::string>& fields) {
        for (const std::string& f : fields) pending_.push_back(number<int>(f));  // may go on over several lines
        if (static_cast<int>(pending_.size()) < corners_ + 1) return;
        if (static_cast<int>(pending_.size()) > corners_ + 1)
            refuse(fmt::format("an element of {} nodes; expected {}", pending_.size() - 1, corners_));
        for (std::size_t k = 1; k < pending_.size(); ++k)
            if (!nodes_.contains(pending_[k]))
                refuse(fmt::format("element {}: node {} is not given above", pending_[0], pending_[k]));
        if (corners_ == 4) {
            quads_.emplace_back();
            std::copy(pending_.begin() + 1, pending_.end(), quads_.back().begin());
        } else {
            hexahedra_.emplace_back();
            std::copy(pending_.begin() + 1, pending_.end(), hexahedra_.back().begin());
            const auto found = std::find(materials_.begin(), materials_.end(), name_);
            material_.push_back(static_cast<int>(found - materials_.begin()));
            if (found == materials_.end()) materials_.push_back(name_);
        }
        pending_.clear();
    }

    void set(const std::vector<std::string>& fields) {
        auto& nodes = sets_[name_];
        if (generate_) {
            if (fields.size() < 2) refuse("a generated set takes its first and last node and a step");
            const int first = number<int>(fields[0]), last = number<int>(fields[1]),
                      step = fields.size() > 2 ? number<int>(fields[2]) : 1;
            if (step <= 0 || last < first || (last - first) / step > 100'000'000)
                refuse(fmt::format("nodes {} to {} in steps of {}", first, last, step));
            for (int id = first; id <= last; id += step) into(nodes, id);
            return;
        }
        for (const std::string& f : fields) {
            if (const auto other = sets_.find(upper(f)); other != sets_.end() && other->first != name_)
                nodes.insert(nodes.end(), other->second.begin(), other->second.end());
            else
                into(nodes, number<int>(f));
        }
    }

    void into(std::vector<int>& nodes, int id) const {
        if (!nodes_.contains(id)) refuse(fmt::format("set {}: node {} is not given above", name_, id));
        nodes.push_back(id);
    }

    /// The elements with their nodes numbered anew, in the order of the file's numbers.
    template <std::size_t N>
    std::vector<std::array<int, N>> used(std::vector<std::array<int, N>> elements, std::vector<Vec3>& nodes,
                                         NodeSets& sets) const {
        std::map<int, int> to;
        for (const auto& e : elements)
            for (const int id : e) to[id] = 0;
        for (auto& [id, index] : to) {
            index = static_cast<int>(nodes.size());
            nodes.push_back(nodes_.at(id));
        }
        for (auto& e : elements)
            for (int& id : e) id = to.at(id);
        for (const auto& [name, ids] : sets_)
            for (const int id : ids)
                if (to.contains(id)) sets[name].push_back(to.at(id));
        return elements;
    }

    std::filesystem::path file_;
    double scale_;
    std::ifstream in_;
    int number_ = 0;
    std::string keyword_, name_;
    bool generate_ = false;
    int corners_ = 0;
    std::vector<int> pending_;  // of the element that is being read
    std::map<int, Vec3> nodes_;
    std::map<std::string, std::vector<int>> sets_;
    std::vector<std::array<int, 4>> quads_;
    std::vector<std::array<int, 8>> hexahedra_;
    std::vector<int> material_;
    std::vector<std::string> materials_;
};
}  // namespace

InpMesh read_inp(const std::filesystem::path& file, double metres_per_unit) {
    return Reader(file, metres_per_unit).read();
}

}  // namespace tw::structure
