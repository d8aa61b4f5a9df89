#include "structure/read_msh.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <set>

#include "base/errors.h"
#include "base/read_file.h"
#include "structure/mesh_builder.h"

namespace tw::structure {
namespace {

class MshReader {
public:
    MshReader(const std::filesystem::path& file, double scale) : file_(file), scale_(scale), in_(file) {
        refuse_no_file(file);
        if (!in_) throw InputError(fmt::format("{}: cannot be read", file.string()));
    }

    MeshFile read() {
        for (std::string section = word(); !section.empty(); section = word()) {
            if (section == "$MeshFormat")
                format();
            else if (version_ == 0)
                refuse(fmt::format("\"{}\"; expected $MeshFormat at the beginning", section));
            else if (section == "$PhysicalNames")
                physical_names();
            else if (section == "$Entities" && version_ == 4)
                entities();
            else if (section == "$Nodes")
                version_ == 4 ? node_blocks() : nodes();
            else if (section == "$Elements")
                version_ == 4 ? element_blocks() : elements();
            else if (section.starts_with("$"))
                skip(section);
            else
                refuse(fmt::format("\"{}\"; expected a section, $...", section));
        }
        if (!mesh_.has_elements()) refuse("no quadrilaterals or hexahedra in this file");
        for (const auto& [name, nodes] : groups_) mesh_.set(name).assign(nodes.begin(), nodes.end());
        return mesh_.finish();
    }

private:
    using Group = std::pair<int, int>;  // dimension and number

    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(fmt::format("{}:{}: {}", file_.string(), line_, why));
    }

    /// The next word, text in quotes as one without them; empty at the file's end.
    std::string word() {
        int c = in_.get();
        for (; c == ' ' || c == '\t' || c == '\r' || c == '\n'; c = in_.get()) line_ += c == '\n';
        std::string out;
        const bool quoted = c == '"';
        if (quoted) c = in_.get();
        for (; c != EOF && c != '\n' && (quoted ? c != '"' : c != ' ' && c != '\t' && c != '\r'); c = in_.get())
            out += static_cast<char>(c);
        if (c == '\n') in_.unget();
        return out;
    }

    template <class Number>
    Number number() {
        const std::string text = word();
        Number value{};
        const char* from = text.data() + (text.starts_with('+') ? 1 : 0);
        const auto [end, error] = std::from_chars(from, text.data() + text.size(), value);
        if (text.empty() || error != std::errc{} || end != text.data() + text.size() ||
            !std::isfinite(static_cast<double>(value)))
            refuse(text.empty() ? "the file ends here; expected a number"
                                : fmt::format("\"{}\"; expected a number", text));
        return value;
    }
    int whole() { return number<int>(); }
    int count() {
        const int n = whole();
        if (n < 0) refuse(fmt::format("a number of {}; expected 0 or more", n));
        return n;
    }
    void pass_over(int numbers) {
        for (int k = 0; k < numbers; ++k) number<double>();
    }
    void end(const std::string& section) {
        const std::string found = word();
        if (found != "$End" + section) refuse(fmt::format("\"{}\"; expected $End{}", found, section));
    }
    void skip(const std::string& section) {
        const std::string last = "$End" + section.substr(1);
        for (std::string w = word(); w != last; w = word())
            if (w.empty()) refuse(fmt::format("the file ends in {}; expected {}", section, last));
    }

    void format() {
        const std::string version = word();
        version_ = version == "4.1" ? 4 : version == "2.2" ? 2 : 0;
        if (version_ == 0 || whole() != 0)
            refuse(fmt::format("version {}, or binary; expected the ASCII format 4.1 or 2.2", version));
        whole();
        end("MeshFormat");
    }

    void physical_names() {
        for (int n = count(); n > 0; --n) {
            const int dimension = whole(), tag = whole();
            names_[{dimension, tag}] = word();
        }
        end("PhysicalNames");
    }

    void entities() {
        const int counts[] = {count(), count(), count(), count()};
        for (int dimension = 0; dimension < 4; ++dimension)
            for (int n = counts[dimension]; n > 0; --n) {
                const int tag = whole();
                pass_over(dimension == 0 ? 3 : 6);  // a place, or a box
                for (int groups = count(); groups > 0; --groups) groups_of_[{dimension, tag}].push_back(whole());
                if (dimension > 0) pass_over(count());  // what bounds it
            }
        end("Entities");
    }

    void node(int id) {
        Vec3 place;
        for (int k = 0; k < 3; ++k) place[k] = scale_ * number<double>();
        if (!mesh_.add_node(id, place)) refuse(fmt::format("node {} is given twice", id));
    }
    void node_blocks() {
        const int blocks = count();
        pass_over(3);  // how many there are, the least and the largest number
        for (int b = 0; b < blocks; ++b) {
            const int dimension = whole();
            whole();
            const bool parametric = whole() != 0;
            std::vector<int> ids(static_cast<std::size_t>(count()));
            for (int& id : ids) id = whole();
            for (const int id : ids) {
                node(id);
                if (parametric) pass_over(dimension);
            }
        }
        end("Nodes");
    }
    void nodes() {
        for (int n = count(); n > 0; --n) node(whole());
        end("Nodes");
    }

    /// Nodes of an element of Gmsh's type.
    int corners(int type, int id) const {
        switch (type) {
            case 15: return 1;  // a point
            case 1: return 2;   // a line
            case 3: return 4;
            case 5: return 8;
        }
        refuse(
            fmt::format("element {} is of type {}; expected quadrilaterals (3) or hexahedra (5) of first order; "
                        "Gmsh's RecombineAll makes them of triangles",
                        id, type));
    }
    void element(int id, int type, int dimension, const std::vector<int>& groups) {
        std::vector<int> n(static_cast<std::size_t>(corners(type, id)));
        for (int& node : n) {
            node = whole();
            if (!mesh_.has_node(node)) refuse(fmt::format("element {}: node {} is not given above", id, node));
        }
        std::string material;
        for (const int tag : groups) {
            const auto name = names_.find(Group(dimension, tag));
            material = name == names_.end() ? fmt::format("GROUP_{}", tag) : name->second;
            groups_[material].insert(n.begin(), n.end());
        }
        if (type == 3) mesh_.add_quad(id, {n[0], n[1], n[2], n[3]});
        if (type == 5) mesh_.add_hexahedron(id, {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]}, material);
    }
    void element_blocks() {
        const int blocks = count();
        pass_over(3);
        for (int b = 0; b < blocks; ++b) {
            const int dimension = whole(), tag = whole(), type = whole();
            const std::vector<int>& groups = groups_of_[{dimension, tag}];
            for (int n = count(); n > 0; --n) element(whole(), type, dimension, groups);
        }
        end("Elements");
    }
    void elements() {
        for (int n = count(); n > 0; --n) {
            const int id = whole(), type = whole(), tags = count();
            std::vector<int> groups;
            for (int k = 0; k < tags; ++k) {
                const int tag = whole();
                if (k == 0 && tag != 0) groups.push_back(tag);  // further ones are geometry and partitions
            }
            element(id, type, type == 15 ? 0 : type == 1 ? 1 : type == 5 ? 3 : 2, groups);
        }
        end("Elements");
    }

    std::filesystem::path file_;
    double scale_;
    std::ifstream in_;
    int line_ = 1, version_ = 0;
    MeshBuilder mesh_;
    std::map<Group, std::string> names_;
    std::map<Group, std::vector<int>> groups_of_;  // of an entity
    std::map<std::string, std::set<int>> groups_;  // nodes of each
};

}  // namespace

MeshFile read_msh(const std::filesystem::path& file, double metres_per_unit) {
    return MshReader(file, metres_per_unit).read();
}

}  // namespace tw::structure
