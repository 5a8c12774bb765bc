#include "app/desktop/man_page.h"
#include "tests/app/desktop/small_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tractus {
namespace {

using testing::HasSubstr;
using testing::Not;

class ManPage : public testing::Test, protected SmallProgram {
protected:
    std::string page(std::string const& verb) { return verb_man_page(*root.get_subcommand(verb)); }
};

TEST_F(ManPage, OfTheProgramNamesEachVerbThatHelpLists)
{
    auto const text = program_man_page(root);
    EXPECT_THAT(text, HasSubstr("\n.SH NAME\ngarden \\- a program for plants\n"));
    EXPECT_THAT(text, HasSubstr("\n.SH DESCRIPTION\nPlants need all of these.\n"));
    EXPECT_THAT(text, HasSubstr("\n.TP\n.BR garden\\-grow (1)\nGrow a plant\n"));
    EXPECT_THAT(text, HasSubstr("garden\\-water"));
    EXPECT_THAT(text, Not(HasSubstr("weed")));
    EXPECT_EQ(man_page_name(root), "garden");
}

TEST_F(ManPage, OfAVerbHasItsArgumentsAndOptionsWithWhatGoesWithThem)
{
    auto const text = page("grow");
    EXPECT_THAT(text, HasSubstr("\n.SH NAME\ngarden\\-grow \\- Grow a plant\n"));
    EXPECT_THAT(text, HasSubstr("\n.B garden grow\n[\\fIOPTIONS\\fR...] \\fIMODEL\\fR\n"));
    EXPECT_THAT(text, HasSubstr("\n.SH ARGUMENTS\n.TP\n\\fIMODEL\\fR\nIts model\n"));
    EXPECT_THAT(text,
                HasSubstr("\n.TP\n\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\nWhat is written "
                          "(required)\n"));
    EXPECT_THAT(text, HasSubstr("What it stands in (default: shade)\n"));
    EXPECT_THAT(text, HasSubstr("\n\\fB\\-\\-dry\\fR\nSay what"));
}

TEST_F(ManPage, KeepsDotsDashesAndIndentedLines)
{
    EXPECT_THAT(page("grow"),
                HasSubstr("\n.PP\nOne line runs on\nin the next.\n.PP\n\\&.Dots and \\-dashes "
                          "stay:\n.PP\n.nf\n  tractus grow\n.fi\n"));
}

TEST_F(ManPage, OfAVerbWithVerbsHasASectionForEach)
{
    auto const text = page("water");
    EXPECT_THAT(text,
                HasSubstr("\n.B garden water well\n[\\fIOPTIONS\\fR...]\n.br\n"
                          ".B garden water little\n"));
    EXPECT_THAT(text, HasSubstr("\n.SH GARDEN WATER WELL\nUntil it stands in it.\n.SS OPTIONS\n"));
    EXPECT_THAT(text, HasSubstr("\\fB\\-\\-warm\\fR\nNot cold\n"));
}

} // namespace
} // namespace tractus
