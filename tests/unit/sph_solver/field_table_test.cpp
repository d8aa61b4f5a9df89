#include <gtest/gtest.h>

#include <set>
#include <string>

#include "sph_solver/fields/particles.h"

namespace tw {
namespace field_table_test {

struct Three : FieldTable {
    FieldOf<double> x{*this, "x", Kept::saved};
    FieldOf<float, Law::scalar> found{*this, "found", Kept::sorted};
    FieldOf<std::int64_t> of_finer{*this, "of_finer", Kept::moved, With::finer};
    Marks marks{*this, "marks", Kept::sorted};
};

Three three() {
    Three t;
    t.allocate(With::finer);
    for (int k = 0; k < 3; ++k) {
        const std::size_t i = t.grow();
        t.x[i] = 10 * k;
        t.of_finer[i] = k;
    }
    t.make_room(0);
    t.found = {5, 6, 7};
    return t;
}

TEST(FieldTable, OnlyWhatMovesIsReordered) {
    Three t = three();
    t.reorder({2, 0});
    EXPECT_EQ(t.x, (std::vector<double>{20, 0}));
    EXPECT_EQ(t.of_finer, (std::vector<std::int64_t>{2, 0}));
    EXPECT_EQ(t.found, (std::vector<float>{5, 6, 7})) << "is found anew after particles were sorted";
}

TEST(FieldTable, ABirthGivesWhatMovesItsDefault) {
    Three t = three();
    EXPECT_EQ(t.grow(), 3u);
    EXPECT_EQ(t.x, (std::vector<double>{0, 10, 20, 0}));
    EXPECT_EQ(t.of_finer.back(), 0);
    EXPECT_EQ(t.found.size(), 3u);
}

TEST(FieldTable, WhatALevelLacksHasNoElements) {
    Three t;
    t.grow();
    EXPECT_TRUE(t.of_finer.empty());
    t.allocate(With::finer);
    EXPECT_EQ(t.of_finer.size(), 1u);
    EXPECT_TRUE(t.has(With::water));
    EXPECT_FALSE(t.has(With::walls));
    Three other;
    other.grow();
    other.allocate_as(t);
    EXPECT_EQ(other.of_finer.size(), 1u);
}

TEST(FieldTable, ImagesHaveWhatHasALaw) {
    Three t = three();
    t.make_room(40);
    EXPECT_EQ(t.found.size(), 43u);
    EXPECT_EQ(t.marks.size(), 43u / 32 + 2) << "a bit each, and a word more";
    EXPECT_EQ(t.x.size(), 3u);
}

TEST(FieldTable, BytesCountsEveryArray) {
    Three t = three();
    EXPECT_EQ(t.bytes(),
              t.x.capacity() * 8 + t.found.capacity() * 4 + t.of_finer.capacity() * 8 + t.marks.capacity() * 4);
    Particles p;
    for (const With with : {With::coarser, With::finer, With::walls, With::moving_bodies, With::elastic_bodies,
                            With::control_volume, With::ventilation, With::sea_at_inlet})
        p.allocate(with);
    p.add(1, 2, 3, 4, 5, 6, Kind::fluid);
    p.make_room(0);
    std::size_t least = 0;
    p.each([&](const AnyField& f) {
        EXPECT_GT(f.bytes(), 0u) << f.name();
        least += f.bytes();
    });
    EXPECT_EQ(p.bytes(), least);
}

TEST(FieldTable, ACopyIsATableOfItsOwn) {
    const Three t = three();
    Three copy = t;
    copy.reorder({1});
    copy.grow();
    EXPECT_EQ(copy.x, (std::vector<double>{10, 0}));
    EXPECT_EQ(t.x, (std::vector<double>{0, 10, 20}));
    Three moved = std::move(copy);
    moved.reorder({0});
    EXPECT_EQ(moved.x, (std::vector<double>{10}));
}

TEST(Particles, WhatIsSavedHasANameOfItsOwnAndHoldsNumbers) {
    std::set<std::string> names;
    const Particles p;
    p.each([&](const AnyField& f) {
        EXPECT_TRUE(names.insert(f.name()).second) << f.name();
        EXPECT_TRUE(!f.saved() || f.element() != AnyField::Element::packed) << f.name();
    });
    EXPECT_TRUE(names.contains("x"));
}

TEST(Particles, TheTableAndTheListOfADeviceAreTheSame) {
    Particles p;
    std::set<const void*> of_list, of_table;
    FieldsView::each(p, p, [&](const AnyField& f, const AnyField&, auto about) {
        of_list.insert(&f);
        EXPECT_EQ(f.moves(), decltype(about)::moves) << f.name();
        EXPECT_EQ(f.with() == With::water, decltype(about)::always) << f.name();
    });
    p.each([&](const AnyField& f) {
        if (&f != &p.surface) of_table.insert(&f);
    });
    EXPECT_EQ(of_list, of_table);
}

TEST(Particles, WhatALevelLacksIsNullInItsView) {
    Particles p;
    p.resize(1);
    EXPECT_EQ(p.view().x, p.x.data());
    EXPECT_EQ(p.view().aired, nullptr);
    p.allocate(With::ventilation);
    EXPECT_EQ(p.view().aired, p.aired.data());
    // one that is added begins without what the one before it had, and a copy has it
    p.aired[0] = Aired::yes, p.x[0] = 2;
    p.resize(3);
    const FieldsView all = p.view();
    all.copy(1, all, 0), all.copy(2, all, 0);
    all.begin(2);
    EXPECT_EQ(p.aired[1], Aired::yes);
    EXPECT_EQ(p.aired[2], Aired::unknown);
    EXPECT_EQ(p.x[2], 2);
}

}  // namespace field_table_test
}  // namespace tw
