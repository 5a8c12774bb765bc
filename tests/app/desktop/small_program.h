#pragma once

#include "app/options/checks.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tractus::desktop {

// A command-line program with two commands, one of which has subcommands, and a hidden command.
struct SmallProgram {
    SmallProgram()
    {
        auto* const grow = root.add_subcommand("grow", "Grow a plant");
        grow->add_option("MODEL", model, "Its model")->required();
        grow->add_option("-o,--output", output, "What is written")->type_name("FILE")->required();
        grow->add_option("--into", folder, "Where it goes")->type_name("FOLDER");
        grow->add_option("--light", light, "What it stands in")
            ->type_name("HOW")
            ->check(options::one_of({ "full sun", "shade" }))
            ->capture_default_str();
        grow->add_option("--device", devices, "What to listen to")->type_name("DEVICE...");
        grow->add_flag("--dry", is_dry, "Say what would be done");
        grow->footer("One line runs on\nin the next.\n\n.Dots and -dashes stay:\n  tractus grow");
        auto* const water = root.add_subcommand("water", "Water a plant");
        water->add_subcommand("well", "Until it stands in it")
            ->add_flag("--warm", is_dry, "Not cold");
        water->add_subcommand("little", "Some drops");
        root.add_subcommand("weed", "Only for who knows it")->group("");
        root.footer("Plants need all of these.");
    }

    CLI::App root { "garden: a program for plants", "garden" };
    std::string model, output, folder, light = "shade";
    std::vector<std::string> devices;
    bool is_dry = false;
};

} // namespace tractus::desktop
