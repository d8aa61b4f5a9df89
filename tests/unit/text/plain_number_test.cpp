#include "text/plain_number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw {
namespace plain_number_test {

TEST(PlainNumber, HasNoPowersOfTenWherePeopleWriteNone) {
    EXPECT_EQ(plain_number(420, 2), "420");
    EXPECT_EQ(plain_number(9512, 2), "9500");
    EXPECT_EQ(plain_number(21345.6), "21300");
    EXPECT_EQ(plain_number(999.7), "1000");
    EXPECT_EQ(plain_number(0.000314159), "0.000314");
    EXPECT_EQ(plain_number(-0.0099996), "-0.01");
    EXPECT_EQ(plain_number(4.0), "4");
    EXPECT_EQ(plain_number(0), "0");
    EXPECT_EQ(plain_number(3e12), "3e+12");  // beyond them a power of ten is the plain form
}

TEST(PlainNumber, WritesWhatHasNoFullPrecisionAndWhatRoundsBeyondTheLargest) {
    EXPECT_EQ(plain_number(1e-320, 2), "1e-320");
    EXPECT_EQ(plain_number(1.797e308, 2), "1.8e+308");
    EXPECT_EQ(plain_number(-INFINITY), "-inf");
}

}  // namespace plain_number_test
}  // namespace tw
