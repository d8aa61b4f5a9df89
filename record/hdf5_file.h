#pragma once
#include <hdf5.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Our HDF5 files check themselves. All metadata (superblock, object headers with their attributes, links, chunk
/// indices) are written in the format of HDF5 1.10, in which each block carries a checksum, and every array is stored
/// in chunks with a Fletcher-32 checksum (https://docs.hdfgroup.org/hdf5/v1_14/_f_m_t3.html). HDF5 refuses to read what
/// does not fit. Whether the whole file is as it was written, says the line behind it (checksum_line.h). Files of the older format, without checksums, are read as well.
namespace tw::h5 {

/// Version of the superblock (the byte behind the signature) from which on metadata carry checksums.
inline constexpr char first_checked_format = 2;

/// Owns one HDF5 identifier and closes it with the function of its kind.
class Handle {
public:
    Handle() = default;
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
    Handle& operator=(Handle&& other) noexcept;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { reset(); }
    void reset();
    operator hid_t() const { return id_; }
    bool open() const { return id_ >= 0; }

private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

/// HDF5 prints its error stack to stderr by default; while this lives it is silent and our own messages speak.
class Silence {
public:
    Silence();
    ~Silence();
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// An HDF5 call failed; the caller turns this into a message that names the file. `what` names the dataset, attribute
/// or group: "dataset tables/forces/fx: checksum does not match: the file is damaged".
struct Failure {
    std::string what;
};
hid_t checked(hid_t id, const char* what);
void checked_status(herr_t status, const char* what);

Handle create_group(hid_t parent, const char* name);
Handle open_group(hid_t parent, const char* name);

void write_attribute(hid_t object, const char* name, const std::string& text);
void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, std::span<const double> values);
void write_attribute(hid_t object, const char* name, std::span<const long long> values);
std::string read_text_attribute(hid_t object, const char* name);
std::vector<double> read_numbers_attribute(hid_t object, const char* name);
bool has_attribute(hid_t object, const char* name);  ///< throws Failure where damage hides the answer
bool has(hid_t parent, const char* name);            ///< likewise
/// Names of an object's attributes in the order of their names.
std::vector<std::string> attribute_names(hid_t object);
/// Names of a group's members in the order in which they were made.
std::vector<std::string> member_names(hid_t group);

/// Writes an array of any rank in checksummed chunks of at most 64k values (one first-dimension row when it is larger);
/// `packed`: shuffle and gzip 1. `memory_type` is also the file's type.
void write_array(hid_t parent, const char* name, hid_t memory_type, const void* data, std::span<const hsize_t> dims,
                 bool packed);
template <class T>
void write_vector(hid_t parent, const char* name, hid_t memory_type, const std::vector<T>& v, bool packed = true) {
    const hsize_t n = v.size();
    write_array(parent, name, memory_type, v.data(), {&n, 1}, packed);
}
void write_texts(hid_t parent, const char* name, const std::vector<std::string>& texts);

Handle open_dataset(hid_t parent, const char* name);
std::vector<hsize_t> dimensions(hid_t parent, const char* name);
/// Reads a whole array whose number of values must be `expected`.
void read_array(hid_t parent, const char* name, hid_t memory_type, void* data, std::size_t expected);
template <class T>
std::vector<T> read_vector(hid_t parent, const char* name, hid_t memory_type) {
    const auto dims = dimensions(parent, name);
    if (dims.size() != 1) throw Failure{std::string(name) + " is not a list"};
    std::vector<T> v(dims[0]);
    read_array(parent, name, memory_type, v.data(), v.size());
    return v;
}
std::vector<std::string> read_texts(hid_t parent, const char* name);

/// A new HDF5 file that lives in memory: a full disk cannot leave HDF5's own caches half-flushed, since the bytes are
/// handed over in one piece and written by ordinary means.
Handle create_in_memory();
std::string image(hid_t file);  ///< flushes and returns the file's bytes

}  // namespace tw::h5
