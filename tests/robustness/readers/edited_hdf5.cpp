#include "tests/robustness/readers/edited_hdf5.h"

#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "record/hdf5_file.h"

namespace tw::readers {
namespace {

/// A dataset, or with `attribute` one of the object's attributes.
struct Place {
    std::string object, attribute;
};

herr_t note_attribute(hid_t object, const char* name, const H5A_info_t*, void* places) {
    std::string path(static_cast<std::size_t>(std::max<ssize_t>(H5Iget_name(object, nullptr, 0), 0)), '\0');
    H5Iget_name(object, path.data(), path.size() + 1);
    static_cast<std::vector<Place>*>(places)->push_back({path, name});
    return 0;
}
herr_t note_object(hid_t root, const char* name, const H5O_info_t* info, void* places) {
    const h5::Handle object(H5Oopen(root, name, H5P_DEFAULT), H5Oclose);
    if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<Place>*>(places)->push_back({name, {}});
    return H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_attribute, places);
}
std::vector<Place> places_in(hid_t file) {
    std::vector<Place> places;
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, note_object, &places, H5O_INFO_BASIC);
    return places;
}

std::size_t count_of(hid_t space) {
    return static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0));
}

/// Numbers as doubles, texts as bytes: what `change` makes of them.
template <class Read, class Write>
void change_values(hid_t type, std::size_t count, std::size_t where, double value, Read read, Write write) {
    if (count == 0) return;
    if (H5Tget_class(type) == H5T_STRING) {
        std::string bytes(count * H5Tget_size(type), '\0');
        if (H5Tis_variable_str(type) > 0 || bytes.empty() || read(type, bytes.data()) < 0) return;
        bytes[where % bytes.size()] = static_cast<char>(std::isfinite(value) ? std::fmod(value, 128) : 0);
        write(type, bytes.data());
        return;
    }
    std::vector<double> numbers(count);
    if (read(H5T_NATIVE_DOUBLE, numbers.data()) < 0) return;
    numbers[where % count] = value;
    write(H5T_NATIVE_DOUBLE, numbers.data());
}

void edit_dataset(hid_t file, const Place& p, unsigned how, std::size_t where, double value) {
    const h5::Handle set(H5Dopen2(file, p.object.c_str(), H5P_DEFAULT), H5Dclose);
    const h5::Handle type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
    if (how <= 1) H5Ldelete(file, p.object.c_str(), H5P_DEFAULT);
    if (how == 1) {
        const hsize_t length = where % 64;
        const h5::Handle line(H5Screate_simple(1, &length, nullptr), H5Sclose);
        const h5::Handle made(H5Dcreate2(file, p.object.c_str(), type, line, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose);
        return;
    }
    change_values(
        type, count_of(space), where, value,
        [&](hid_t as, void* to) { return H5Dread(set, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, to); },
        [&](hid_t as, const void* from) { return H5Dwrite(set, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, from); });
}

void edit_attribute(hid_t file, const Place& p, unsigned how, std::size_t where, double value) {
    const h5::Handle object(H5Oopen(file, p.object.c_str(), H5P_DEFAULT), H5Oclose);
    h5::Handle attribute(H5Aopen(object, p.attribute.c_str(), H5P_DEFAULT), H5Aclose);
    const h5::Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
    if (how <= 1) attribute.reset(), H5Adelete(object, p.attribute.c_str());
    if (how == 1) {
        const hsize_t length = where % 64;
        const h5::Handle line(H5Screate_simple(1, &length, nullptr), H5Sclose);
        const h5::Handle made(H5Acreate2(object, p.attribute.c_str(), type, line, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
        const std::string zeros(length * H5Tget_size(type), '\0');
        H5Awrite(made, type, zeros.data());
    }
    if (how <= 1) return;
    change_values(
        type, count_of(space), where, value, [&](hid_t as, void* to) { return H5Aread(attribute, as, to); },
        [&](hid_t as, const void* from) { return H5Awrite(attribute, as, from); });
}

}  // namespace

void edit_hdf5(const std::filesystem::path& path, std::string_view edits) {
    const h5::Silence silence;
    const h5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    constexpr std::size_t bytes_an_edit = 12, most = 16;
    for (std::size_t n = 0; n < most && edits.size() >= bytes_an_edit; ++n, edits.remove_prefix(bytes_an_edit)) {
        std::uint16_t which = 0, how = 0;
        double value = 0;
        std::memcpy(&which, edits.data(), 2), std::memcpy(&how, edits.data() + 2, 2);
        std::memcpy(&value, edits.data() + 4, 8);
        const std::vector<Place> places = places_in(file);
        if (places.empty()) return;
        const Place& place = places[which % places.size()];
        const unsigned way = how % 8;
        if (place.attribute.empty())
            edit_dataset(file, place, way, how / 8, value);
        else
            edit_attribute(file, place, way, how / 8, value);
    }
}

}  // namespace tw::readers
