// What another program may have put into an HDF5 file in place of what we write.
#include "record/hdf5_file.h"

#include <gtest/gtest.h>

#include <array>

namespace tw {
namespace hdf5_file_test {

h5::Handle text_of_length(std::size_t length) {
    h5::Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, length);
    return type;
}
h5::Handle list_of(hsize_t length) { return {H5Screate_simple(1, &length, nullptr), H5Sclose}; }

TEST(Hdf5Text, IsOneText) {
    const h5::Handle file = h5::create_in_memory();
    const auto put = [&](const char* name, hsize_t texts) {
        const h5::Handle type = text_of_length(3), space = list_of(texts);
        const h5::Handle attribute(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
        ASSERT_GE(H5Awrite(attribute, type, "abcdefghi"), 0);
    };
    put("one", 1), put("three", 3);
    EXPECT_EQ(h5::read_text_attribute(file, "one"), "abc");
    EXPECT_THROW(h5::read_text_attribute(file, "three"), h5::Failure);  // more bytes than one text has
}

/// Their bytes are 2^64, which no number of bytes can be.
TEST(Hdf5Texts, OfASenselessNumberAreRefused) {
    const h5::Handle file = h5::create_in_memory();
    const h5::Handle type = text_of_length(1 << 16), space = list_of(hsize_t{1} << 48);
    const h5::Handle chunks(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const std::array<hsize_t, 1> one{1};
    ASSERT_GE(H5Pset_chunk(chunks, 1, one.data()), 0);
    const h5::Handle set(H5Dcreate2(file, "names", type, space, H5P_DEFAULT, chunks, H5P_DEFAULT), H5Dclose);
    ASSERT_TRUE(set.open());
    EXPECT_THROW(h5::read_texts(file, "names"), h5::Failure);
}

}  // namespace hdf5_file_test
}  // namespace tw
