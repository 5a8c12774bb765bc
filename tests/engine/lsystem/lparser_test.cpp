#include "engine/lsystem/notations/lparser_text.h"
#include "engine/lsystem/rewriting/homomorphism.h"
#include "tests/corpus.h"
#include "tests/engine/lsystem/corpus_strings.h"
#include "tests/engine/lsystem/small_model.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

namespace tractus::lsystem {
namespace {

ImportedModel imported(std::string const& text)
{
    auto const made = read_lparser_model("tree.ls", text);
    EXPECT_TRUE(made) << made.error().message;
    return made ? *made : ImportedModel {};
}

std::string refused(std::string const& text)
{
    auto const made = read_lparser_model("tree.ls", text);
    return made ? "no error" : made.error().message;
}

// Draws an axiom of LParser, with an angle of 90 degrees and a thickness of a tenth of the length.
Plant drawn_by_lparser(std::string const& axiom)
{
    auto const made = imported("0\n90\n10\n" + axiom + "\n");
    auto const model = compiled(made.text, made.view);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    auto const string = derive(model);
    EXPECT_TRUE(string) << string.error().message;
    auto plant = interpret(model, *string, { .unit_mm = 1 });
    EXPECT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
    return *std::move(plant);
}

// Returns the lengths of all segments, sorted.
std::vector<double> lengths_of(Plant const& plant)
{
    std::vector<double> lengths;
    for (SegmentId i = 0; i < plant.segment_count(); ++i) {
        auto const [base, tip] = nodes_of(plant, i);
        auto const length_mm = (plant.node_position_mm[tip] - plant.node_position_mm[base]).norm();
        lengths.push_back(std::round(length_mm * 100) / 100);
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

// The bush is figure 1.25 of The Algorithmic Beauty of Plants, as users of LParser write it: >
// stands for the / of the book.
TEST(LParser, GrowsTheBooksBush)
{
    auto const made = imported("# A bush\n7 # recursion\n22.5 # angle\n80\n#\nA\n"
                               "A=[&FL!A]>>>>>'[&FL!A]>>>>>>>'[&FL!A]\nF=S>>>>>F\nS=FL\n"
                               "L=['''^^{-f+f+f-|-f+f+f}]\n@\nnot read\n");
    auto const model = compiled(made.text, made.view);
    EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    auto const counted = read_json(shipped("lsystem_counts") / "counts.json");
    auto const& systems = counted["systems"];
    auto const bush = std::find_if(systems.begin(), systems.end(),
                                   [](auto const& system) { return system["id"] == "bush3d_125"; });
    ASSERT_NE(bush, systems.end());
    for (auto const& [steps, expected] : (*bush)["after_n_steps"].items()) {
        auto const string = derive(model, { .steps = std::stoi(steps), .seed = 1 });
        ASSERT_TRUE(string) << string.error().message;
        auto const counts = count_symbols(model, *string);
        for (std::string const letter : { "A", "F", "L", "S", "[", "]", "&", "{", "f", "!" }) {
            auto const found = counts.find(letter);
            EXPECT_EQ(found == counts.end() ? 0 : found->second,
                      expected["counts"].value(letter, std::size_t { 0 }))
                << letter << " after " << steps;
        }
        auto const plant = interpret(model, *string);
        ASSERT_TRUE(plant) << plant.error().message;
        EXPECT_EQ(plant->segment_count(), expected["counts"].value("F", std::size_t { 0 }));
    }
}

TEST(LParser, BranchesInheritAndGiveBackFactors)
{
    EXPECT_EQ(lengths_of(drawn_by_lparser("F'F['F\"(2)F]FZF(7)")),
              (std::vector<double> { 7, 45, 81, 90, 90, 100, 162 }));
    auto const thick = drawn_by_lparser("F?F[!(0.5)F]F");
    EXPECT_NEAR(thick.node_radius_mm[0], 5, 1e-4);
    EXPECT_NEAR(thick.node_radius_mm[1], 7, 1e-4);
    EXPECT_NEAR(thick.node_radius_mm[2], 7, 1e-4);
    // :(0.5) halves the angle of 90 degrees, so two turns are 90 degrees. The angle set in the
    // branch only holds there.
    auto const turned = drawn_by_lparser(":(0.5)[;(4)+F]++F");
    ASSERT_EQ(turned.segment_count(), 2u);
    EXPECT_NEAR(turned.node_position_mm[1].z(), -100, 1e-3);
    EXPECT_NEAR(turned.node_position_mm[3].z(), 0, 1e-3);
    EXPECT_NEAR(turned.node_position_mm[3].x(), -100, 1e-3);
}

// Rewrites text letter by letter, as LParser does. A number in parentheses stays behind the text
// that replaces its letter.
std::string rewritten(std::string text, std::map<char, std::string> const& rules, int steps)
{
    for (int step = 0; step < steps; ++step) {
        std::string next;
        bool is_number = false;
        for (char const c : text) {
            is_number = is_number || c == '(';
            auto const rule = is_number ? rules.end() : rules.find(c);
            next += rule == rules.end() ? std::string(1, c) : rule->second;
            is_number = is_number && c != ')';
        }
        text = next;
    }
    return text;
}

// Returns the count of each letter outside parentheses.
std::map<std::string, std::size_t> letters_in(std::string const& text)
{
    std::map<std::string, std::size_t> result;
    bool is_number = false;
    for (char const c : text) {
        is_number = is_number || c == '(';
        if (!is_number)
            ++result[std::string(1, c)];
        is_number = is_number && c != ')';
    }
    return result;
}

TEST(LParser, RewritesAsLParserDoes)
{
    std::map<char, std::string> const rules { { 'A', "[+(30)B'F]%;A$" },
                                              { 'B', "c(3)\"BZ~(5)!" },
                                              { 'F', "'(1.3)F'(.77)" },
                                              { '1', "2" },
                                              { '2', "1<G" },
                                              { 'Z', "" } };
    std::string text = "4\n20\n15\nF(20)A1?\n";
    for (auto const& [letter, successor] : rules)
        text += std::string(1, letter) + " = " + (successor.empty() ? "_" : successor) + "\n";
    auto const model = compiled(imported(text + "@\n").text);
    for (int steps = 0; steps <= 5; ++steps) {
        auto const string = derive(model, { .steps = steps, .seed = 1 });
        ASSERT_TRUE(string) << string.error().message;
        auto wanted = letters_in(rewritten("F(20)A1?", rules, steps));
        auto const counts = count_symbols(model, *string);
        for (std::string const letter : { "A", "B", "F", "Z", "G", "c", "1", "2", "[", "]", "!" }) {
            auto const found = counts.find(letter);
            EXPECT_EQ(found == counts.end() ? 0 : found->second, wanted[letter])
                << letter << " after " << steps;
        }
        std::size_t all = 1; // The first module sets the factors.
        for (auto const& [letter, count] : wanted)
            all += letter == "[" || letter == "]" ? 2 * count : count;
        EXPECT_EQ(string->size(), all) << steps;
    }
}

TEST(LParser, ReadsTheWordsOfVersion5)
{
    auto const made = imported("recursion 2\nangle 10\nthickness 80\nshape 1\ncolor 1 255 0 0\n"
                               "axiom FS\nrule S = Z'!cS\nrule 1 = 2\n");
    auto const model = compiled(made.text, made.view);
    EXPECT_EQ(count_symbols(model, *derive(model)).at("Z"), 2u);
}

TEST(LParser, SaysWhatItCannotRead)
{
    EXPECT_EQ(refused("4\nx\n"), "tree.ls:2: found 'x', expected a number");
    EXPECT_EQ(refused("4\n20\n15\n"), "tree.ls:3: the file ends before the axiom");
    EXPECT_EQ(refused("4\n20\n15\nF(a)\n"),
              "tree.ls:4: found '(a)', expected a number in parentheses");
    EXPECT_EQ(refused("4\n20\n15\nF\nF\n"),
              "tree.ls:5: found 'F', expected a rule such as A=F[+A]A");
    auto const drooping = imported("4\n20\n15\nFtF\n");
    EXPECT_EQ(drooping.warnings.size(), 1u);
    EXPECT_TRUE(compiled(drooping.text).warnings.empty());
    // If the text is cut off anywhere, the result must be an error or a valid model.
    std::string const text = "4\n20\n15\nF(2)A#\nA=[+(30)F]'A\n@\n";
    for (std::size_t size = 0; size < text.size(); ++size)
        if (auto const made = read_lparser_model("tree.ls", text.substr(0, size)))
            EXPECT_EQ(compile_error(made->text), "no error") << size;
}

} // namespace
} // namespace tractus::lsystem
