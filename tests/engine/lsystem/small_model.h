#pragma once

#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/language/print.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::lsystem {

// Compiles rules, which must be valid.
inline Model compiled(std::string const& rules, std::string const& view = {})
{
    ModelSource source;
    source.text = rules;
    source.view_text = view;
    auto model = compile_model(source);
    EXPECT_TRUE(model) << model.error().message;
    return model ? *std::move(model) : Model {};
}

// Returns rules with the header and the last line that every model needs.
inline std::string with_header(std::string const& axiom_and_rules, int steps = 1)
{
    return "Lsystem: 1\nderivation length: " + std::to_string(steps) + "\n" + axiom_and_rules
        + "\nendlsystem\n";
}

// Returns the string that is derived from the axiom in `steps` steps.
inline std::string derived(std::string const& axiom_and_rules, int steps = 1,
                           std::uint64_t seed = 1)
{
    auto const model = compiled(with_header(axiom_and_rules, steps));
    auto const string = derive(model, { .steps = {}, .seed = seed });
    EXPECT_TRUE(string) << string.error().message;
    return string ? to_string(model, *string) : std::string();
}

// Returns the error message for invalid rules, or for an invalid view.
inline std::string compile_error(std::string const& rules, std::string const& view = {})
{
    ModelSource source;
    source.text = rules;
    source.view_text = view;
    auto const model = compile_model(source);
    if (model)
        return "no error";
    EXPECT_EQ(model.error().fault, Fault::User);
    return model.error().message;
}

// Returns the plant that a string of turtle symbols draws, with a turtle unit of 1 mm.
inline Plant drawn(std::string const& axiom, std::string const& view = {})
{
    auto const model = compiled(with_header("Axiom: " + axiom, 0), view);
    auto const string = derive(model);
    EXPECT_TRUE(string) << string.error().message;
    auto plant = interpret(model, *string, { .unit_mm = 1 });
    EXPECT_TRUE(plant) << plant.error().message;
    if (!plant)
        return {};
    check_plant(*plant);
    return *std::move(plant);
}

} // namespace tractus::lsystem
