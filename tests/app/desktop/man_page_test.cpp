#include "app/desktop/man_page.h"
#include "tests/app/desktop/small_program.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::desktop {
namespace {

bool contains(std::string const& text, std::string const& part)
{
    return text.find(part) != std::string::npos;
}

class ManPage : public testing::Test, protected SmallProgram {
protected:
    std::string page(std::string const& command)
    {
        return command_man_page(*root.get_subcommand(command));
    }
};

TEST_F(ManPage, OfTheProgramNamesEachCommandThatHelpLists)
{
    auto const text = program_man_page(root);
    EXPECT_PRED2(contains, text, "\n.SH NAME\ngarden \\- a program for plants\n");
    EXPECT_PRED2(contains, text, "\n.SH DESCRIPTION\nPlants need all of these.\n");
    EXPECT_PRED2(contains, text, "\n.TP\n.BR garden\\-grow (1)\nGrow a plant\n");
    EXPECT_PRED2(contains, text, "garden\\-water");
    EXPECT_EQ(text.find("weed"), std::string::npos);
    EXPECT_EQ(man_page_name(root), "garden");
}

TEST_F(ManPage, OfACommandHasItsArgumentsAndOptionsWithWhatGoesWithThem)
{
    auto const text = page("grow");
    EXPECT_PRED2(contains, text, "\n.SH NAME\ngarden\\-grow \\- Grow a plant\n");
    EXPECT_PRED2(contains, text, "\n.B garden grow\n[\\fIOPTIONS\\fR...] \\fIMODEL\\fR\n");
    EXPECT_PRED2(contains, text, "\n.SH ARGUMENTS\n.TP\n\\fIMODEL\\fR\nIts model\n");
    EXPECT_PRED2(contains, text,
                 "\n.TP\n\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR\nWhat is written "
                 "(required)\n");
    EXPECT_PRED2(contains, text, "What it stands in (default: shade)\n");
    EXPECT_PRED2(contains, text, "\n\\fB\\-\\-dry\\fR\nSay what");
}

TEST_F(ManPage, KeepsDotsDashesAndIndentedLines)
{
    EXPECT_PRED2(contains, page("grow"),
                 "\n.PP\nOne line runs on\nin the next.\n.PP\n\\&.Dots and \\-dashes "
                 "stay:\n.PP\n.nf\n  tractus grow\n.fi\n");
}

TEST_F(ManPage, OfACommandWithCommandsHasASectionForEach)
{
    auto const text = page("water");
    EXPECT_PRED2(contains, text,
                 "\n.B garden water well\n[\\fIOPTIONS\\fR...]\n.br\n"
                 ".B garden water little\n");
    EXPECT_PRED2(contains, text, "\n.SH GARDEN WATER WELL\nUntil it stands in it.\n.SS OPTIONS\n");
    EXPECT_PRED2(contains, text, "\\fB\\-\\-warm\\fR\nNot cold\n");
}

} // namespace
} // namespace tractus::desktop
