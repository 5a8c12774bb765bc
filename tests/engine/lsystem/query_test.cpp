#include "engine/lsystem/derivation/query.h"

#include "tests/engine/lsystem/small_model.h"

#include <gtest/gtest.h>
#include <vector>

namespace tractus::lsystem {
namespace {

std::vector<float> parameters_of(std::string const& axiom_and_rules, int steps = 0)
{
    auto const model = compiled(with_header(axiom_and_rules, steps));
    auto const string = derive(model);
    EXPECT_TRUE(string) << string.error().message;
    auto const span = string->parameters.span();
    return { span.begin(), span.end() };
}

void expect_near(std::vector<float> const& found, std::vector<float> const& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-6f) << i;
}

TEST(Queries, GiveTheTurtlesPositionAndFrame)
{
    expect_near(parameters_of("Axiom: ?P(9,9,9)?H(9,9,9)?L(9,9,9)?U(9,9,9)"),
                { 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, -1 });
    expect_near(parameters_of("Axiom: FF+(90)F[&(90)?P(9,9,9)?H(9,9,9)]?L(9,9,9)?U(9,9,9)"),
                { 90, 90, -1, 2, 0, 0, 0, -1, 0, -1, 0, 0, 0, -1 });
    expect_near(parameters_of("Axiom: FF?P(9)?P(9,9,9,9)"), { 0, 0, 2, 0, 9 });
    // The quaternion must rotate the x, y and z axes to heading, left and up.
    auto const q = parameters_of("Axiom: ?Q(9,9,9,9)");
    Quat const turn(Eigen::Vector4d(q[0], q[1], q[2], q[3]));
    EXPECT_LT((turn * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-6);
    EXPECT_LT((turn * Vec3::UnitY() + Vec3::UnitX()).norm(), 1e-6);
}

TEST(Queries, AreSeenByTheNextStep)
{
    EXPECT_EQ(derived("Axiom: A?P(0,0,0)\nA > ?P(x,y,z) : y<3 --> FA", 10), "FFFA?P(0,3,0)");
    EXPECT_EQ(derived("Axiom: F?P(0,0,0)\n?P(x,y,z) --> B(y)?P(x,y,z)F", 2),
              "FB(1)B(1)?P(0,1,0)FF");
}

TEST(Queries, SeeWhatTheHomomorphismDraws)
{
    auto const model = compiled(with_header("Axiom: A(2)?P(0,0,0)?P(0,0,0)\nhomomorphism\n"
                                            "A(n) --> F(n)?P(7,7,7)F(n)",
                                            1));
    EXPECT_EQ(to_string(model, *derive(model)), "A(2)?P(0,4,0)?P(0,4,0)");
}

TEST(Queries, FollowSubLSystems)
{
    auto const model = compiled(with_header("Axiom: F?(2,0.5)A$?P(0,0,0)", 1)
                                + "Lsystem: 2\nA --> F?P(0,0,0)\nhomomorphism\nF --> FF\n"
                                  "endlsystem\n");
    EXPECT_EQ(to_string(model, *derive(model)), "F?(2,0.5)F?P(0,2,0)$?P(0,2,0)");
}

TEST(Queries, AreFilledInLargePlants)
{
    auto const model = compiled(with_header("Axiom: A?P(0,0,0)\nA --> AA[F(0)]\nhomomorphism\n"
                                            "A --> F(1)[+F(1)?P(1,1,1)]",
                                            17));
    auto const string = derive(model);
    ASSERT_TRUE(string) << string.error().message;
    ASSERT_GE(string->parameters.size(), 3u);
    auto const* const last = string->parameters.data() + string->parameters.size() - 3;
    EXPECT_NEAR(last[0], 0, 1e-3f);
    EXPECT_EQ(last[1], 131072.0f);

    // Nearly the whole string is inside of open branches, a generalised cylinder and a patch.
    auto const rich = compiled(with_header("Axiom: [[@PS(1)@Gs[@Gc(2)A]F]F]?P(0,0,0)\nA --> AA\n"
                                           "homomorphism\nA --> F(1)@Gc(2)[+F(1)~l@Gc(2)]@PD(1)",
                                           16));
    auto const answered = derive(rich);
    ASSERT_TRUE(answered) << answered.error().message;
    EXPECT_EQ(answered->parameters[answered->parameters.size() - 2], 0.0f);
}

TEST(Queries, AreModulesLikeOthersWithoutAQuestion)
{
    EXPECT_EQ(derived("Axiom: FP(1,2,3)?\nP(x,y,z) --> P(z,y,x)"), "FP(3,2,1)?");
    EXPECT_EQ(derived("Axiom: ?\n? --> ???", 1), "???");
}

// An environment that limits growth to a box: it gives 0 to modules outside.
void prune(std::span<EnvironmentQuery const> queries)
{
    for (auto const& query : queries) {
        bool const is_inside = std::abs(query.position.x()) <= 4 && query.position.y() <= 6;
        query.parameters[0] = is_inside ? 1.0f : 0.0f;
    }
}

TEST(Environment, PrunesGrowthInABox)
{
    auto const model = compiled(with_header("Axiom: A?E(1)\n"
                                            "A > ?E(x) : x>0 --> F[+(35)A?E(1)]-(25)A\n"
                                            "A > ?E(x) : x==0 --> X",
                                            12));
    DeriveOptions options;
    int calls = 0;
    options.environment = [&](int step, std::span<EnvironmentQuery const> queries) {
        EXPECT_EQ(step, calls++ % 13);
        prune(queries);
        return Result<void>();
    };
    auto const pruned = derive(model, options);
    ASSERT_TRUE(pruned) << pruned.error().message;
    // The environment is asked in each of the 12 steps, and also about the axiom.
    EXPECT_EQ(calls, 13);
    auto const plant = interpret(model, *pruned, { .unit_mm = 1 });
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_GT(plant->segment_count(), 50u);
    for (auto const& node : plant->node_position_mm) {
        EXPECT_LE(std::abs(node.x()), 5); // A single step may lead out of the box.
        EXPECT_LE(node.z(), 7);
    }
    auto const wild = derive(model);
    EXPECT_GT(count_symbols(model, *wild).at("F"), 2 * plant->segment_count());
    EXPECT_EQ(to_string(model, *derive(model, options)), to_string(model, *pruned));
}

TEST(Environment, SeesAllQueriesOfAStepAtOnce)
{
    auto const model
        = compiled(with_header("Axiom: !(0.5)F(2)?E(1,2)~l(3)[+(90)@D(2)F?E]?E(5)", 0));
    DeriveOptions options;
    int calls = 0;
    options.environment = [&](int, std::span<EnvironmentQuery const> queries) {
        ++calls;
        EXPECT_EQ(queries.size(), 3u);
        if (queries.size() != 3)
            return Result<void>();
        EXPECT_EQ(queries[0].module, 2u);
        EXPECT_EQ(queries[0].position, Vec3(0, 2, 0));
        EXPECT_EQ(queries[0].line_width, 0.5);
        EXPECT_EQ(queries[0].next_symbol, '~');
        EXPECT_EQ(queries[0].parameters[1], 2.0f);
        EXPECT_TRUE(queries[1].parameters.empty());
        EXPECT_NEAR(queries[1].position.x(), -2, 1e-12);
        EXPECT_NEAR(queries[1].heading.x(), -1, 1e-12);
        EXPECT_EQ(queries[1].scale, 2);
        EXPECT_EQ(queries[2].next_symbol, 0);
        queries[0].parameters[1] = 7;
        queries[2].parameters[0] = 8;
        return Result<void>();
    };
    EXPECT_EQ(to_string(model, *derive(model, options)),
              "!(0.5)F(2)?E(1,7)~l(3)[+(90)@D(2)F?E]?E(8)");
    EXPECT_EQ(calls, 1);
}

TEST(Cuts, EndTheDrawingOnlyIfTheViewSaysSo)
{
    EXPECT_EQ(drawn("F[FF%FF]F").segment_count(), 6u);
    EXPECT_EQ(drawn("F[FF%FF]F", "interpretation past %: on\n").segment_count(), 6u);
    EXPECT_EQ(drawn("F[FF%FF]F", "interpretation past %: off\n").segment_count(), 4u);
}

// As in cpfg, in the step after a cut the branch moves to the end of the string. It stays at its
// position in space.
TEST(KeptCuts, GoToTheStringsEnd)
{
    std::string const rules = "Axiom: F[+(90)F(2)A]F(3)\nA --> %(7)F(4)B\nB --> F(1)B";
    EXPECT_EQ(derived(rules, 1), "F[+(90)F(2)%(7)F(4)B]F(3)");
    EXPECT_EQ(derived(rules, 2), "F[+(90)F(2)]F(3)%(7,0)F(4)F(1)B");
    EXPECT_EQ(derived(rules, 3), "F[+(90)F(2)]F(3)%(7,0)F(4)F(1)F(1)B");
    auto const model = compiled(with_header(rules, 2));
    auto const plant = interpret(model, derive(model).value(), { .unit_mm = 10 }).value();
    check_plant(plant);
    ASSERT_EQ(plant.axes.size(), 3u);
    auto const& axis = plant.axes[2];
    EXPECT_EQ(axis.parent_segment, kNone); // The branch has fallen off its parent.
    auto const nodes = plant.positions(axis);
    EXPECT_LT((nodes.front() - Vec3(-20, 0, 10)).norm(), 1e-9);
    EXPECT_LT((nodes.back() - Vec3(-70, 0, 10)).norm(), 1e-9);
}

TEST(KeptCuts, EndBeforeTheNextOneAndInsideOfPlainOnes)
{
    // The first cut keeps A, and the second keeps B. Each of these continues separately.
    EXPECT_EQ(derived("Axiom: F%(1)AF%(2)BF\nA --> C\nB --> D"), "F%(1,0)CF%(2,1)DF");
    EXPECT_EQ(derived("Axiom: [F%AF%(2)BF]F\nB --> D"), "[F]F%(2,0)DF");
    EXPECT_EQ(derived("Axiom: [F%A[%(2)B]F]F\nB --> D"), "[F]F");
    // A rule for the module of the cut is applied like any other rule.
    EXPECT_EQ(derived("Axiom: F%(1)A\n%(x) --> G(x+1)"), "FG(2)A");
}

// The modules behind a %(x) are separate from those before it: contexts do not extend across the
// cut.
TEST(KeptCuts, EndContexts)
{
    std::string const rules = "\nA < B --> C\nA > B --> D\nA < F > B --> G";
    EXPECT_EQ(derived("Axiom: AB%(1,0)AB" + rules), "DC%(1,0)DC");
    EXPECT_EQ(derived("Axiom: A%(1,0)BA%(2,1)FB" + rules), "A%(1,0)BA%(2,1)FB");
    // In the step of the cut, modules still have the contexts from before the cut.
    EXPECT_EQ(derived("Axiom: A[%(1)B]B" + rules), "D[]C%(1,0)B");
    EXPECT_EQ(derived("ignore: %\nAxiom: A%(1,0)B" + rules), "A%(1,0)B");
}

// The turtles of branches that were cut off must keep their numbers from step to step.
TEST(KeptCuts, StayApartOverManySteps)
{
    EXPECT_EQ(derived("Axiom: A(0)\nA(i) --> F[%(i)L]A(i+1)", 3),
              "F[]F[]F[%(2)L]A(3)%(0,0)L%(1,1)L");
}

// Returns the string after some steps, derived with a turtle that stops at cuts.
std::string derived_up_to_cuts(std::string const& axiom_and_rules, int steps = 0)
{
    auto const model
        = compiled(with_header(axiom_and_rules, steps), "interpretation past %: off\n");
    return to_string(model, derive(model).value());
}

// As in cpfg, a cut removes its branch in the following step. Until then, queries behind the cut
// are answered like all others.
TEST(QueriesBehindCuts, AreAnsweredUntilTheyGo)
{
    std::string const axiom = "Axiom: [F%F?P(9,9,9)[F?P(9,9,9)]%F?P(9,9,9)]F?P(9,9,9)";
    EXPECT_EQ(derived(axiom, 0), "[F%F?P(0,2,0)[F?P(0,3,0)]%F?P(0,3,0)]F?P(0,1,0)");
    EXPECT_EQ(derived(axiom, 1), "[F]F?P(0,1,0)");
}

TEST(QueriesBehindCuts, KeepTheirValuesWhereTheTurtleStopsAtCuts)
{
    EXPECT_EQ(derived_up_to_cuts("Axiom: F[F%F[F?P(9,9,9)]?P(9,9,9)]F?P(9,9,9)%F?P(9,9,9)"),
              "F[F%F[F?P(9,9,9)]?P(9,9,9)]F?P(0,2,0)%F?P(9,9,9)");
    EXPECT_EQ(derived_up_to_cuts("Axiom: A%F?P(9,9,9)\nignore: %F\nA > ?P(x,y,z) --> B(y)", 1),
              "B(9)");
    // A cut in a sub-L-system ends at the end of the sub-L-system.
    auto const model = compiled(with_header("Axiom: F?(2)F%F?P(9,9,9)$F?P(9,9,9)", 0)
                                    + "Lsystem: 2\nA --> A\nendlsystem\n",
                                "interpretation past %: off\n");
    EXPECT_EQ(to_string(model, derive(model).value()), "F?(2)F%F?P(9,9,9)$F?P(0,3,0)");
}

// A cut takes effect only while its string is rewritten. So rules still see the modules behind it.
TEST(QueriesBehindCuts, AreSeenByContextsInTheStepOfTheCut)
{
    EXPECT_EQ(derived("Axiom: FA%F?P(9,9,9)\nignore: %F\nA > ?P(x,y,z) --> B(y)"), "FB(2)");
    EXPECT_EQ(derived("Axiom: FA%?P(9,9,9)\nA > %?P(x,y,z) --> B(y)"), "FB(1)");
    EXPECT_EQ(derived("Axiom: A[F%?P(9,9,9)]\nA > [F%?P(x,y,z)] --> B(y)"), "B(1)[F]");
}

// When an apex leaves its bounds, a rule makes a cut of it. The modules that it produced in the
// same step are removed with it.
TEST(QueriesBehindCuts, GoWithWhatARuleCutsOff)
{
    std::string const rules = "Axiom: FA\nA --> [+(90)B]F?P(9,9,9)A\nB --> F?P(9,9,9)B\n"
                              "?P(x,y,z) : y > 2.5 || x < -1.5 --> X%";
    EXPECT_EQ(derived(rules, 2), "F[+(90)F?P(-1,1,0)B]F?P(0,2,0)[+(90)B]F?P(0,3,0)A");
    EXPECT_EQ(derived(rules, 3),
              "F[+(90)F?P(-1,1,0)F?P(-2,1,0)B]F?P(0,2,0)[+(90)F?P(-1,2,0)B]FX%"
              "[+(90)B]F?P(0,4,0)A");
    EXPECT_EQ(derived(rules, 4),
              "F[+(90)F?P(-1,1,0)FX%F?P(-3,1,0)B]F?P(0,2,0)[+(90)F?P(-1,2,0)F?P(-2,2,0)B]FX");
    EXPECT_EQ(derived(rules, 6), "F[+(90)F?P(-1,1,0)FX]F?P(0,2,0)[+(90)F?P(-1,2,0)FX]FX");
}

// Modules that %(x) cuts off move to the end of the string, but stay at their position in space.
TEST(QueriesBehindCuts, AreAnsweredWhereTheKeptBranchIs)
{
    std::string const rules = "Axiom: F[-(90)F%(5)FA?P(9,9,9)[F?P(9,9,9)]]F?P(9,9,9)\nA --> FA";
    EXPECT_EQ(derived(rules, 0), "F[-(90)F%(5)FA?P(2,1,0)[F?P(3,1,0)]]F?P(0,2,0)");
    EXPECT_EQ(derived(rules, 2), "F[-(90)F]F?P(0,2,0)%(5,0)FFFA?P(4,1,0)[F?P(5,1,0)]");
    // That also holds if the turtle stops at plain cuts: the part that a plain cut hides ends at
    // the next %(x).
    EXPECT_EQ(derived_up_to_cuts("Axiom: F%F?P(9,9,9)%(1)F?P(9,9,9)"),
              "F%F?P(9,9,9)%(1)F?P(0,2,0)");
    EXPECT_EQ(derived_up_to_cuts("Axiom: F%F?P(9,9,9)%(1)F?P(9,9,9)", 1), "F%(1,0)F?P(0,2,0)");
}

TEST(QueriesBehindCuts, AreCutOnlyByTheStringItself)
{
    auto const answered = [](std::string const& axiom, std::string const& homomorphism) {
        return derived_up_to_cuts("Axiom: " + axiom + "\nhomomorphism\n" + homomorphism);
    };
    EXPECT_EQ(answered("AF?P(9,9,9)", "A --> F%F"), "AF?P(0,3,0)");
    EXPECT_EQ(answered("F%F?P(9,9,9)", "% --> F"), "F%F?P(0,3,0)");
    // The homomorphism replaces ?P, so there is no query to answer.
    EXPECT_EQ(answered("F?P(9,9,9)?H(9,9,9)", "?P(x,y,z) --> F"), "F?P(9,9,9)?H(0,1,0)");
    EXPECT_EQ(answered("F?P(9,9,9)?P(9,9,9)", "P(x,y,z) --> F"), "F?P(0,1,0)?P(0,1,0)");
}

TEST(QueriesBehindCuts, AskTheEnvironmentUntilTheyGo)
{
    auto const model = compiled(with_header("Axiom: F%F?E(9)", 1));
    DeriveOptions options;
    std::vector<std::size_t> asked;
    options.environment = [&](int, std::span<EnvironmentQuery const> queries) {
        asked.push_back(queries.size());
        for (auto const& query : queries)
            EXPECT_EQ(query.position, Vec3(0, 2, 0));
        return Result<void>();
    };
    EXPECT_EQ(to_string(model, derive(model, options).value()), "F");
    // Only the axiom has a query.
    EXPECT_EQ(asked, std::vector<std::size_t> { 1 });
}

// A branch that is cut off may contain another cut. cpfg then leaves unbalanced brackets, since it
// ends a part at the next %(x) inside, at any depth. Here each part is kept separately, from the
// outermost part on.
TEST(KeptCuts, KeepWhatBranchesOfTheCutOnesKeep)
{
    EXPECT_EQ(derived("Axiom: F[F%(1)F[+(90)F%(2)F?P(9,9,9)]F?P(9,9,9)]F?P(9,9,9)"),
              "F[F]F?P(0,2,0)%(1,0)F[+(90)F]F?P(0,4,0)%(2,1)F?P(-2,3,0)");
}

} // namespace
} // namespace tractus::lsystem
