#include "record/hdf5_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace tw::h5 {

Handle& Handle::operator=(Handle&& other) noexcept {
    if (this != &other) {
        reset();
        id_ = other.id_;
        close_ = other.close_;
        other.id_ = -1;
    }
    return *this;
}

void Handle::reset() {
    if (id_ >= 0 && close_) close_(id_);
    id_ = -1;
}

Silence::Silence() {
    // At the end of the program HDF5 would complain about what damaged files have left open inside it. Nothing of ours
    // is lost: whole files are written at once, see create_in_memory.
    static const herr_t no_clean_up = H5dont_atexit();
    static_cast<void>(no_clean_up);
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}
Silence::~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

hid_t checked(hid_t id, const char* what) {
    if (id < 0) throw Failure{what};
    return id;
}
void checked_status(herr_t status, const char* what) {
    if (status < 0) throw Failure{what};
}

namespace {

/// Where an object's member or attribute is, without the root's slash: "tables/forces/fx".
std::string path_of(hid_t object, const char* name) {
    std::string path(static_cast<std::size_t>(std::max<ssize_t>(H5Iget_name(object, nullptr, 0), 0)), '\0');
    if (!path.empty()) H5Iget_name(object, path.data(), path.size() + 1);
    path.erase(0, path.find_first_not_of('/'));
    return path.empty() ? name : path + "/" + name;
}

/// Why something below `parent` cannot be opened: it was never there, or its description is damaged.
Failure cannot_open(const char* kind, hid_t parent, const char* name) {
    const bool absent = H5Lexists(parent, name, H5P_DEFAULT) == 0;
    return {std::string(kind) + " " + path_of(parent, name) +
            (absent ? " is not there" : ": its description cannot be read: the file is damaged")};
}
Handle open_attribute(hid_t object, const char* name) {
    Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    if (!attribute.open()) throw Failure{"attribute " + path_of(object, name) + " is not there or damaged"};
    return attribute;
}

bool has_checksum(hid_t set) {
    const Handle options(H5Dget_create_plist(set), H5Pclose);
    unsigned flags = 0;
    return options.open() &&
           H5Pget_filter_by_id2(options, H5Z_FILTER_FLETCHER32, &flags, nullptr, nullptr, 0, nullptr, nullptr) >= 0;
}

/// The same bytes for the same content, whenever it is written; and attributes stay in the object's own header, whose
/// checksum covers them, up to 64 kB each.
void plain_header(hid_t creation) {
    checked_status(H5Pset_obj_track_times(creation, false), "options");
    checked_status(H5Pset_attr_phase_change(creation, 65535, 0), "options");
}

Handle scalar_space() { return {checked(H5Screate(H5S_SCALAR), "space"), H5Sclose}; }

/// Text is stored at its own fixed length, UTF-8, at least one byte (HDF5 knows no text of length zero).
Handle text_type(std::size_t length) {
    Handle type(checked(H5Tcopy(H5T_C_S1), "text type"), H5Tclose);
    checked_status(H5Tset_size(type, std::max<std::size_t>(length, 1)), "text size");
    checked_status(H5Tset_strpad(type, H5T_STR_NULLPAD), "text padding");
    checked_status(H5Tset_cset(type, H5T_CSET_UTF8), "text encoding");
    return type;
}

void write_numbers(hid_t object, const char* name, hid_t type, hid_t space, const void* data) {
    const Handle attribute(checked(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), name), H5Aclose);
    checked_status(H5Awrite(attribute, type, data), name);
}
}  // namespace

Handle create_group(hid_t parent, const char* name) {
    const Handle order(checked(H5Pcreate(H5P_GROUP_CREATE), "group options"), H5Pclose);
    plain_header(order);
    checked_status(H5Pset_link_creation_order(order, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "group options");
    return {checked(H5Gcreate2(parent, name, H5P_DEFAULT, order, H5P_DEFAULT), name), H5Gclose};
}
Handle open_group(hid_t parent, const char* name) {
    Handle group(H5Gopen2(parent, name, H5P_DEFAULT), H5Gclose);
    if (!group.open()) throw cannot_open("group", parent, name);
    return group;
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
    const Handle type = text_type(text.size()), space = scalar_space();
    write_numbers(object, name, type, space, text.empty() ? "" : text.data());
}
void write_attribute(hid_t object, const char* name, double value) {
    const Handle space = scalar_space();
    write_numbers(object, name, H5T_NATIVE_DOUBLE, space, &value);
}
void write_attribute(hid_t object, const char* name, std::span<const double> values) {
    const hsize_t n = values.size();
    const Handle space(checked(H5Screate_simple(1, &n, nullptr), "space"), H5Sclose);
    write_numbers(object, name, H5T_NATIVE_DOUBLE, space, values.data());
}
void write_attribute(hid_t object, const char* name, std::span<const long long> values) {
    const hsize_t n = values.size();
    const Handle space(checked(H5Screate_simple(1, &n, nullptr), "space"), H5Sclose);
    write_numbers(object, name, H5T_NATIVE_LLONG, space, values.data());
}

std::string read_text_attribute(hid_t object, const char* name) {
    const Handle attribute = open_attribute(object, name);
    const Handle type(checked(H5Aget_type(attribute), name), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING) throw Failure{std::string(name) + " is not text"};
    const Handle space(checked(H5Aget_space(attribute), name), H5Sclose);
    if (H5Sget_simple_extent_npoints(space) != 1) throw Failure{std::string(name) + " is not one text"};
    if (H5Tis_variable_str(type) > 0) {  // written by other tools, e.g. h5py
        char* text = nullptr;
        checked_status(H5Aread(attribute, type, &text), name);
        std::string copy = text ? text : "";
        H5free_memory(text);
        return copy;
    }
    std::string text(H5Tget_size(type), '\0');
    checked_status(H5Aread(attribute, type, text.data()), name);
    text.resize(std::strlen(text.c_str()));
    return text;
}

std::vector<double> read_numbers_attribute(hid_t object, const char* name) {
    const Handle attribute = open_attribute(object, name);
    const Handle space(checked(H5Aget_space(attribute), name), H5Sclose);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    if (n < 1 || n > 1000) throw Failure{std::string(name) + " has a senseless size"};
    std::vector<double> values(static_cast<std::size_t>(n));
    checked_status(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()), name);
    return values;
}

bool has_attribute(hid_t object, const char* name) {
    const htri_t there = H5Aexists(object, name);
    if (there < 0) throw Failure{"attribute " + path_of(object, name) + " cannot be looked for: the file is damaged"};
    return there > 0;
}
bool has(hid_t parent, const char* name) {
    const htri_t there = H5Lexists(parent, name, H5P_DEFAULT);
    if (there < 0) throw Failure{path_of(parent, name) + " cannot be looked for: the file is damaged"};
    return there > 0;
}

std::vector<std::string> attribute_names(hid_t object) {
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
        static_cast<std::vector<std::string>*>(data)->push_back(name);
        return 0;
    };
    hsize_t index = 0;
    checked_status(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &index, add, &names), "attributes");
    return names;
}

std::vector<std::string> member_names(hid_t group) {
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
        static_cast<std::vector<std::string>*>(data)->push_back(name);
        return 0;
    };
    // Groups made by other tools may not keep the order of creation: their names decide then.
    if (H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, &names) < 0) {
        names.clear();
        checked_status(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "members");
    }
    return names;
}

Handle open_dataset(hid_t parent, const char* name) {
    Handle set(H5Dopen2(parent, name, H5P_DEFAULT), H5Dclose);
    if (!set.open()) throw cannot_open("dataset", parent, name);
    return set;
}

void write_array(hid_t parent, const char* name, hid_t memory_type, const void* data, std::span<const hsize_t> dims,
                 bool packed) {
    const Handle space(checked(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr), name), H5Sclose);
    const Handle options(checked(H5Pcreate(H5P_DATASET_CREATE), name), H5Pclose);
    plain_header(options);
    const bool empty = std::ranges::find(dims, hsize_t{0}) != dims.end();
    if (!empty) {
        std::vector<hsize_t> chunk(dims.begin(), dims.end());
        hsize_t row = 1;
        for (std::size_t k = 1; k < chunk.size(); ++k) row *= chunk[k];
        chunk[0] = std::clamp<hsize_t>(65536 / row, 1, dims[0]);
        checked_status(H5Pset_chunk(options, static_cast<int>(chunk.size()), chunk.data()), name);
        if (packed) {
            checked_status(H5Pset_shuffle(options), name);
            checked_status(H5Pset_deflate(options, 1), name);
        }
        checked_status(H5Pset_fletcher32(options), name);
    }
    const Handle set(checked(H5Dcreate2(parent, name, memory_type, space, H5P_DEFAULT, options, H5P_DEFAULT), name),
                     H5Dclose);
    if (!empty) checked_status(H5Dwrite(set, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), name);
}

void write_texts(hid_t parent, const char* name, const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const auto& t : texts) longest = std::max(longest, t.size());
    std::string bytes(longest * texts.size(), '\0');
    for (std::size_t i = 0; i < texts.size(); ++i)
        std::ranges::copy(texts[i], bytes.begin() + static_cast<std::ptrdiff_t>(i * longest));
    const Handle type = text_type(longest);
    const hsize_t n = texts.size();
    write_array(parent, name, type, bytes.data(), {&n, 1}, false);
}

std::vector<hsize_t> dimensions(hid_t parent, const char* name) {
    const Handle set = open_dataset(parent, name);
    const Handle space(checked(H5Dget_space(set), name), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || rank > 8) throw Failure{name};
    std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
    if (rank > 0) checked_status(H5Sget_simple_extent_dims(space, dims.data(), nullptr), name);
    return dims;
}

void read_array(hid_t parent, const char* name, hid_t memory_type, void* data, std::size_t expected) {
    const Handle set = open_dataset(parent, name);
    const Handle space(checked(H5Dget_space(set), name), H5Sclose);
    if (H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(expected))
        throw Failure{"dataset " + path_of(parent, name) + " has the wrong size"};
    if (expected > 0 && H5Dread(set, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
        throw Failure{"dataset " + path_of(parent, name) +
                      (has_checksum(set) ? ": checksum does not match" : ": cannot be read") + ": the file is damaged"};
}

std::vector<std::string> read_texts(hid_t parent, const char* name) {
    const Handle set = open_dataset(parent, name);
    const Handle type(checked(H5Dget_type(set), name), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0)
        throw Failure{std::string(name) + " is not fixed-length text"};
    const std::size_t width = H5Tget_size(type);
    const auto dims = dimensions(parent, name);
    if (dims.size() != 1) throw Failure{std::string(name) + " is not a list"};
    if (width == 0 || dims[0] > (hsize_t{1} << 40) / width)
        throw Failure{std::string(name) + " claims a senseless size"};
    std::string bytes(width * dims[0], '\0');
    read_array(parent, name, type, bytes.data(), dims[0]);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < dims[0]; ++i) {
        std::string t = bytes.substr(i * width, width);
        t.resize(std::strlen(t.c_str()));
        texts.push_back(std::move(t));
    }
    return texts;
}

Handle create_in_memory() {
    const Handle access(checked(H5Pcreate(H5P_FILE_ACCESS), "file options"), H5Pclose);
    checked_status(H5Pset_fapl_core(access, std::size_t{4} << 20, false), "file options");
    checked_status(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), "file options");
    const Handle creation(checked(H5Pcreate(H5P_FILE_CREATE), "file options"), H5Pclose);
    plain_header(creation);
    return {checked(H5Fcreate("in memory", H5F_ACC_TRUNC, creation, access), "file"), H5Fclose};
}

namespace {

/// HDF5's checksum of metadata: Bob Jenkins, lookup3.c (2006, public domain), hashlittle with initial value 0.
std::uint32_t lookup3(std::string_view bytes) {
    std::uint32_t a = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size()), b = a, c = a;
    const auto word = [&](std::size_t from) {
        std::uint32_t w = 0;
        for (std::size_t k = 0; k < 4 && from + k < bytes.size(); ++k)
            w |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[from + k])) << (8 * k);
        return w;
    };
    const auto add = [&](std::size_t from) { a += word(from), b += word(from + 4), c += word(from + 8); };
    std::size_t at = 0;
    for (; bytes.size() - at > 12; at += 12) {
        add(at);
        a -= c, a ^= std::rotl(c, 4), c += b;
        b -= a, b ^= std::rotl(a, 6), a += c;
        c -= b, c ^= std::rotl(b, 8), b += a;
        a -= c, a ^= std::rotl(c, 16), c += b;
        b -= a, b ^= std::rotl(a, 19), a += c;
        c -= b, c ^= std::rotl(b, 4), b += a;
    }
    add(at);
    c ^= b, c -= std::rotl(b, 14);
    a ^= c, a -= std::rotl(c, 11);
    b ^= a, b -= std::rotl(a, 25);
    c ^= b, c -= std::rotl(b, 16);
    a ^= c, a -= std::rotl(c, 4);
    b ^= a, b -= std::rotl(a, 14);
    c ^= b, c -= std::rotl(b, 24);
    return c;
}

/// H5Fget_file_image clears the mark "open for writing" in the superblock and leaves its checksum stale: this sets it.
void sign_superblock(std::string& file) {
    constexpr std::size_t before_checksum = 44;  // superblock version 2 and 3 with addresses of 8 bytes
    const std::uint32_t sum = lookup3(std::string_view(file).substr(0, before_checksum));
    for (std::size_t k = 0; k < 4; ++k) file[before_checksum + k] = static_cast<char>(sum >> (8 * k));
}

}  // namespace

std::string image(hid_t file) {
    checked_status(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    if (size < 0) throw Failure{"file image"};
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (H5Fget_file_image(file, bytes.data(), bytes.size()) != size) throw Failure{"file image"};
    sign_superblock(bytes);
    return bytes;
}

}  // namespace tw::h5
