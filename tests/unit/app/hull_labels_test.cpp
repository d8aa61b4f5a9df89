#include "app/campaign/hull_labels.h"

#include <gtest/gtest.h>

namespace tw::app {
namespace hull_labels_test {

using Labels = std::vector<std::string>;

TEST(HullLabels, AreTheStemsWhereTheyDiffer) {
    EXPECT_EQ(hull_labels({"a/first.stl", "b/second.stl"}), (Labels{"first", "second"}));
    EXPECT_EQ(hull_labels({{}}), Labels{""});
}

// A sweep of a/hull.stl and b/hull.stl had two rows of one name.
TEST(HullLabels, HaveTheFoldersThatTellThemApart) {
    EXPECT_EQ(hull_labels({"a/hull.stl", "b/hull.stl", "b/other.stl"}), (Labels{"a/hull", "b/hull", "other"}));
    EXPECT_EQ(hull_labels({"a/x/hull.stl", "b/x/hull.stl"}), (Labels{"a/x/hull", "b/x/hull"}));
    EXPECT_EQ(hull_labels({"hull.stl", "b/hull.stl"}), (Labels{"hull", "b/hull"}));
    EXPECT_EQ(hull_labels({"../hull.stl", "/tmp/hull.stl"}), (Labels{"../hull", "tmp/hull"}));
}

TEST(HullLabels, HaveTheEndingWhereNothingElseDiffers) {
    EXPECT_EQ(hull_labels({"hull.stl", "hull.step"}), (Labels{"hull.stl", "hull.step"}));
    EXPECT_EQ(hull_labels({"hull.stl", "hull.stl"}), (Labels{"hull", "hull"})) << "one file given twice is one hull";
}

}  // namespace hull_labels_test
}  // namespace tw::app
