#include "engine/methods/sketch_lsystem/axis_contract.h"

#include "engine/methods/sketch_lsystem/model_rule.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <string>
#include <vector>

namespace tractus::sketch {
namespace {

std::string const kKept = R"(/* length[3] = {1} in a comment is no array. */
#define SEGMENTS 0 /* drawn */
Lsystem: 1
derivation length: 9
define: { array length[2] = {5, 4}; // and no other
          array plane[1] = {0}, bend[1] = { 0 }; }
Axiom: K(0)
K(i) : i < SEGMENTS --> /(plane[i]) + (bend[i]) \(plane[i]) F(length[i]) [+(40 + ran(20))F(2)] K(i + 1)
endlsystem
)";

std::string replaced(std::string text, std::string const& what, std::string const& by)
{
    return text.replace(text.find(what), what.size(), by);
}

std::vector<std::string> lacks(std::string const& text)
{
    return read_contract("m.l", text).lacks;
}

std::vector<std::string> lacks_when_grown(std::string const& text)
{
    ModelRule model;
    model.source.name = "m.l";
    model.source.text = text;
    return missing_for_stroke(model, {});
}

TEST(AxisContract, IsFoundInAText)
{
    auto const reading = read_contract("m.l", kKept);
    EXPECT_EQ(reading.lacks, std::vector<std::string> {});
    auto const& contract = reading.contract;
    EXPECT_EQ(contract.count_name, "SEGMENTS");
    EXPECT_EQ(contract.lengths, (std::vector<double> { 5, 4 }));
    EXPECT_EQ(kKept.substr(contract.count.begin, contract.count.size), "0");
    EXPECT_EQ(kKept.substr(contract.length.begin, contract.length.size), "[2] = {5, 4}");
    EXPECT_EQ(kKept.substr(contract.bend.begin, contract.bend.size), "[1] = { 0 }");
    EXPECT_EQ(lacks_when_grown(kKept), std::vector<std::string> {});
}

TEST(AxisContract, ChangesNothingElseInTheText)
{
    auto const contract = contract_of("m.l", kKept).value();
    auto const text = with_values(kKept, contract, { 2, "{5, 4}", "{90, 0}", "{30, 0}" });
    auto expected = replaced(kKept, "SEGMENTS 0 ", "SEGMENTS 2 ");
    expected = replaced(expected, "length[2] = {5, 4}; //", "length[SEGMENTS] = {5, 4}; //");
    expected = replaced(expected, "plane[1] = {0}", "plane[SEGMENTS] = {90, 0}");
    expected = replaced(expected, "bend[1] = { 0 }", "bend[SEGMENTS] = {30, 0}");
    EXPECT_EQ(text, expected);
}

TEST(AxisContract, MayCallItsCountN)
{
    auto text = kKept;
    for (int i = 0; i < 2; ++i)
        text = replaced(text, "SEGMENTS", "N");
    EXPECT_EQ(lacks(text), std::vector<std::string> {});
}

TEST(AxisContract, SaysWhatLacks)
{
    EXPECT_EQ(
        lacks("Lsystem: 1\nderivation length: 1\nAxiom: F(1)\nendlsystem\n"),
        (std::vector<std::string> {
            "m.l: it has no line #define SEGMENTS 0, the number of segments that a stroke has",
            "m.l: it has no array length with values: give it define: { array length[1] = "
            "{10}; }",
            "m.l: it has no array plane with values: give it define: { array plane[1] = {0}; "
            "}",
            "m.l: it has no array bend with values: give it define: { array bend[1] = {0}; }",
            "m.l: no rule turns the drawn axis by /(plane[i])+(bend[i])\\(plane[i])" }));
    EXPECT_EQ(lacks(replaced(kKept, "SEGMENTS 0", "SEGMENTS (2 * 3)")),
              (std::vector<std::string> {
                  "m.l:2: #define SEGMENTS is no whole number: give it 0, "
                  "which is the plant without a stroke",
              }));
    EXPECT_EQ(lacks(replaced(kKept, "{5, 4}", "{5, -4}")),
              (std::vector<std::string> {
                  "m.l:5: the values of length[] are not all plain numbers above 0" }));
    EXPECT_EQ(lacks(replaced(kKept, "\\(plane[i])", "\\(plane[0])")),
              (std::vector<std::string> {
                  "m.l:8: /(plane[i]) is not followed by +(bend[i])\\(plane[i])" }));
    EXPECT_EQ(lacks(replaced(kKept, "F(length[i])", "F(5)")),
              (std::vector<std::string> {
                  "m.l:8: no F(length[i]) follows the turn, which draws the segment" }));
    EXPECT_EQ(lacks(replaced(kKept, "i < SEGMENTS", "i < 7")),
              (std::vector<std::string> {
                  "m.l: no rule ends the drawn axis by a condition i < SEGMENTS" }));
}

// A text that has all parts of the contract (axis_contract.h) may nevertheless not follow a stroke.
TEST(AxisContract, IsTriedWithAStroke)
{
    auto const leaves_at = [](std::string const& text) {
        auto const all = lacks_when_grown(text);
        return all.size() == 1 ? all.front() : std::string("none or many");
    };
    auto const says = [](int segment) {
        return "m.l: its first axis leaves the stroke at segment " + std::to_string(segment) + ":";
    };
    EXPECT_EQ(leaves_at(replaced(kKept, "Axiom: K(0)", "Axiom: &(2)K(0)")).find(says(1)), 0u);
    EXPECT_EQ(leaves_at(replaced(kKept, "[+(40", "/(90)[+(40")).find(says(2)), 0u);
    EXPECT_EQ(leaves_at(replaced(kKept, "[+(40", "+(nran(0, 3))[+(40")).find(says(2)), 0u);
    EXPECT_EQ(leaves_at(replaced(kKept, "length: 9", "length: 4")).find(says(5)), 0u);
    EXPECT_NE(leaves_at(replaced(kKept, "F(2)", "F(2")).find("m.l:8:"), std::string::npos);
}

// If the parts of the contract (axis_contract.h) are found in a text, they can be replaced, and
// must then be found again.
TEST(AxisContract, IsFoundAgainInAnyTextThatKeepsIt)
{
    EXPECT_TRUE(rc::check([] {
        auto text = kKept;
        auto const changes = *rc::gen::inRange(0, 4);
        for (int i = 0; i < changes; ++i) {
            auto const at = *rc::gen::inRange<std::size_t>(0, text.size());
            auto const by = *rc::gen::element<std::string>(
                "", " ", "\n", "/*", "*/", "//", "{", "]", "\"", "\\\n", "#define N 3\n", "\r\n");
            text.replace(at, *rc::gen::inRange<std::size_t>(0, 3), by);
        }
        auto const contract = contract_of("m.l", text);
        RC_CLASSIFY(contract.has_value());
        if (!contract)
            return;
        auto const along = with_values(text, *contract, { 2, "{7, 6}", "{90, 0}", "{30, 0}" });
        auto const again = contract_of("m.l", along);
        RC_ASSERT(again.has_value());
        RC_ASSERT(again->lengths == (std::vector<double> { 7, 6 }));
        RC_ASSERT(along.substr(again->count.begin, again->count.size) == "2");
    }));
}

TEST(AxisContract, RefusesAModelThatDoesNotKeepIt)
{
    auto const contract = contract_of("m.l", replaced(kKept, "F(length[i])", "F(5)"));
    ASSERT_FALSE(contract);
    EXPECT_EQ(contract.error().message,
              "m.l:8: no F(length[i]) follows the turn, which draws the segment, so it cannot grow "
              "along a stroke; \"tractus lsystem check\" says all that it lacks");
}

} // namespace
} // namespace tractus::sketch
