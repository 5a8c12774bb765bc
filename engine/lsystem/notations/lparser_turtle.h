#pragma once

#include <array>
#include <string_view>

namespace tractus::lsystem {

// How LParser's turtle draws a letter without a parameter and with a parameter x, each as the
// condition and successor of a homomorphism rule. The arrays `len`, `turn` and `wide` contain
// length, angle and width; their index d is the depth of the branch. Source: the list of commands
// in LParser's manual.
struct LParserCommand {
    char letter = 0;
    std::string_view plain;
    std::string_view with_number;
};

inline constexpr std::array kLParserCommands {
    LParserCommand { '+', "* --> +(turn[d])", "* --> +(x)" },
    LParserCommand { '-', "* --> -(turn[d])", "* --> -(x)" },
    LParserCommand { '&', "* --> &(turn[d])", "* --> &(x)" },
    LParserCommand { '^', "* --> ^(turn[d])", "* --> ^(x)" },
    LParserCommand { '<', "* --> \\(turn[d])", "* --> \\(x)" },
    LParserCommand { '>', "* --> /(turn[d])", "* --> /(x)" },
    LParserCommand { '%', "* --> /(180)", "* --> /(180)" },
    LParserCommand { '$', "* --> @v", "* --> @v" },
    LParserCommand { '~', "* --> +(ran(12)-6)&(ran(12)-6)/(ran(12)-6)",
                     "* --> +(ran(2*x)-x)&(ran(2*x)-x)/(ran(2*x)-x)" },
    LParserCommand { 'F', "* --> !(wide[d])F(len[d])", "* --> !(wide[d])F(x)" },
    LParserCommand { 'Z', "* --> !(wide[d])F(len[d]/2)", "* --> !(wide[d])F(x)" },
    LParserCommand { 'f', "* --> f(len[d])", "* --> f(x)" },
    LParserCommand { 'z', "* --> f(len[d]/2)", "* --> f(x)" },
    LParserCommand { 'g', "* --> g(len[d])", "* --> g(x)" },
    LParserCommand { 'G', "* --> *", "* --> *" },
    LParserCommand { 't', "* --> *", "* --> *" }, // Droop is not supported.
    LParserCommand { 'c', "* --> ;", "* --> ;(x)" },
    LParserCommand { '"', "{len[d] = len[d] * 1.1;} 1 --> *", "{len[d] = len[d] * x;} 1 --> *" },
    LParserCommand { '\'', "{len[d] = len[d] * 0.9;} 1 --> *", "{len[d] = len[d] * x;} 1 --> *" },
    LParserCommand { ';', "{turn[d] = turn[d] * 1.1;} 1 --> *",
                     "{turn[d] = turn[d] * x;} 1 --> *" },
    LParserCommand { ':', "{turn[d] = turn[d] * 0.9;} 1 --> *",
                     "{turn[d] = turn[d] * x;} 1 --> *" },
    LParserCommand { '?', "{wide[d] = wide[d] * 1.4;} 1 --> *",
                     "{wide[d] = wide[d] * x;} 1 --> *" },
    LParserCommand { '!', "{wide[d] = wide[d] * 0.7;} 1 --> *",
                     "{wide[d] = wide[d] * x;} 1 --> *" },
};

// Statements for the view that define LParser's colour numbers, with colours close to those of its
// viewer.
inline constexpr std::string_view kLParserColors
    = "color: 1 0.1,0.1,0.1\ncolor: 2 0.8,0.1,0.1\n"
      "color: 3 0.85,0.8,0.1\ncolor: 4 0.2,0.65,0.15\n"
      "color: 5 0.1,0.7,0.7\ncolor: 6 0.15,0.2,0.8\n"
      "color: 7 0.75,0.15,0.7\ncolor: 8 0.1,0.4,0.1\n"
      "color: 9 0.1,0.4,0.45\ncolor: 10 0.1,0.1,0.45\n"
      "color: 11 0.45,0.1,0.4\ncolor: 12 0.42,0.28,0.16\n"
      "color: 13 0.15,0.35,0.1\ncolor: 14 0.5,0.5,0.5\n"
      "color: 15 0.95,0.95,0.95\ninitial color: 12\n";

} // namespace tractus::lsystem
