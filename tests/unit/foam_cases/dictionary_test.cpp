// An OpenFOAM file is a value; nothing but the program's own structure can come out of it.
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

#include "base/errors.h"
#include "foam_cases/dictionary.h"

namespace tw {
namespace dictionary_test {

TEST(Dictionary, IsSpelledAsOpenFoamReadsIt) {
    Dictionary d{
        {"type", Word("fixedValue")}, {"value", Value::sequence({Word("uniform"), Vec3(8, 0, -0.5)})}, {"on", true}};
    d.add("box", List{Vec3(0, 0, 0), Vec3(1, 2, 3)});
    d.add("inner", Dictionary{{"file", Quoted("hull.eMesh")}, {"level", 3}});
    EXPECT_EQ(d.text(),
              "type            fixedValue;\n"
              "value           uniform (8 0 -0.5);\n"
              "on              yes;\n"
              "box             ((0 0 0) (1 2 3));\n"
              "inner\n"
              "{\n"
              "    file            \"hull.eMesh\";\n"
              "    level           3;\n"
              "}\n");
}

TEST(Dictionary, FieldsAndTablesHaveOneLineForEachElement) {
    const Dictionary field{{"internalField", Value::nonuniform(std::vector<Vec3>{{0, 0, 0}, {1, -2, 3}})}};
    EXPECT_EQ(field.text(),
              "internalField\n"
              "nonuniform List<vector> 2\n(\n(0 0 0)\n(1 -2 3)\n);\n");
    const std::string table =
        foam_list_file("dictionary", "droplets", {Value::sequence({Vec3(0, 0, 1), 0.001}), Value(2)});
    EXPECT_NE(table.find("object          droplets;"), std::string::npos);
    EXPECT_TRUE(table.ends_with("\n2\n(\n(0 0 1) 0.001\n2\n)\n")) << table;
    EXPECT_THROW(Value::nonuniform(std::vector<Vec3>{{0, std::nan(""), 0}}), InputError);
}

TEST(Dictionary, KeepsTheOrderOfItsKeysAndRefusesOneTwice) {
    Dictionary d{{"z", 1}, {"a", 2}};
    EXPECT_LT(d.text().find("z "), d.text().find("a "));
    EXPECT_THROW(d.add("z", 3), InputError);
}

TEST(Dictionary, NumbersKeepEveryDigitInAnyLocale) {
    const char* before = std::setlocale(LC_ALL, nullptr);
    const std::string saved = before != nullptr ? before : "C";
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // a decimal comma, where that locale is installed
    const std::string text =
        Value(0.1).text() + " " + Value(1.0 / 3).text() + " " + Value(1e-8).text() + " " + Value(-0.0).text();
    std::setlocale(LC_ALL, saved.c_str());
    EXPECT_EQ(text, "0.1 0.3333333333333333 1e-08 0");
    EXPECT_THROW(Value(std::nan("")), InputError);
    EXPECT_THROW(Value(Vec3(0, INFINITY, 0)), InputError);
}

TEST(Dictionary, NamedListElementsBecomeBlocks) {
    const Value boundary{List{Value::named(Word("inlet"), Dictionary{{"type", Word("patch")}})}};
    EXPECT_EQ(boundary.text(), "(\n    inlet\n    {\n        type            patch;\n    }\n)");
}

/// What somebody might put into a title, a probe's or an obstacle's name.
const char* const attacks[] = {"x; #calc \"1\"",
                               "#calc",
                               "#codeStream",
                               "#include \"/etc/passwd\"",
                               "$x",
                               "${HOME}",
                               "$(touch x)",
                               "`touch x`",
                               "a; application evil",
                               "a } functions { b",
                               "a\"b",
                               "a'b",
                               "a\nb",
                               "a // b",
                               "a /* b",
                               "a\\b",
                               "a)b",
                               "(a",
                               "<script>",
                               "\xc3\xa4",
                               "a\tb",
                               ""};

TEST(Dictionary, NoTextOpensADirectiveAStringOrAnotherDictionary) {
    for (const char* attack : attacks) {
        EXPECT_THROW(Word{attack}, InputError) << attack;
        if (std::string(attack) != "<script>") { EXPECT_THROW(Quoted{attack}, InputError) << attack; }  // "<case>/mesh"
        EXPECT_THROW(Key{attack}, InputError) << attack;
    }
    EXPECT_THROW(Key{"a b"}, InputError);  // would be a key and the beginning of a value
    EXPECT_THROW(Key{"1a"}, InputError);
    EXPECT_NO_THROW(Word{"Gauss linear limited corrected 0.5"});
    EXPECT_NO_THROW(Key{"div(((rho*nuEff)*dev2(T(grad(U)))))"});
}

TEST(Dictionary, AnyNameBecomesAWord) {
    for (const char* attack : attacks) EXPECT_NO_THROW(Key{word_from(attack, "obstacle")}) << attack;
    EXPECT_EQ(word_from("box 1", "obstacle"), "box_1");
    EXPECT_EQ(word_from("1st", "obstacle"), "part_1st");
    EXPECT_EQ(word_from("", "obstacle"), "obstacle");
}

}  // namespace dictionary_test
}  // namespace tw
