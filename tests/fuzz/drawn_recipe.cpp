#include "tests/fuzz/drawn_recipe.h"

#include "app/document/logged_step.h"
#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "app/tools/tool.h"
#include "calib/rig_file.h"
#include "drivers/logs/log_writer.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace tractus {

namespace {

constexpr std::size_t kMaxOperations = 40; // Longer drawings only take longer.

class RecipeWriter {
public:
    explicit RecipeWriter(FuzzInput input)
        : input_(input)
    {
    }

    std::string write() &&
    {
        for (std::size_t i = 0; i < kMaxOperations && !input_.text().empty(); ++i)
            operation(input_.take_byte());
        return text_.str();
    }

private:
    void operation(unsigned byte)
    {
        switch (byte % 8) {
        case 0:
        case 1:
            return stroke(byte / 8);
        case 2:
            return tool(byte / 8);
        case 3:
            return history(byte / 8);
        case 4:
            return step();
        case 5:
            return pause(byte / 8);
        case 6:
            return report(byte / 8);
        default:
            return line();
        }
    }

    Timestamp now() const { return at_ms(now_ms_); }

    double share() { return input_.take_byte() / 255.0; }

    // A polyline over the whole tablet, and over the whole way of the carriage.
    void stroke(unsigned shape)
    {
        constexpr int kSamplesPerPiece = 6;
        std::array<double, 3> from { share(), share(), share() };
        for (unsigned piece = 0; piece < 1 + shape % 6; ++piece) {
            std::array const to { share(), share(), share() };
            for (int i = 0; i < kSamplesPerPiece; ++i) {
                double const part = i / double { kSamplesPerPiece };
                sample({ from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]),
                         from[2] + part * (to[2] - from[2]) },
                       true);
            }
            from = to;
        }
        sample(from, false);
        ++strokes_;
    }

    void sample(std::array<double, 3> const& place, bool touches)
    {
        constexpr int kGreatestReading = 4095;
        for (int i = 0; i < 2; ++i) {
            now_ms_ += 2;
            writer_.write_report(kHeight, now(),
                                 height_report(static_cast<int>(kGreatestReading * place[2])));
        }
        writer_.write_report(kPen, now(), pen_report(200 * place[0], 100 * place[1], touches));
    }

    // Selects a tool with some of its options set, or does it at once.
    void tool(unsigned how)
    {
        auto const kinds = methods::all_methods().tools;
        auto hand = tools::default_tool_of_kind(*kinds[input_.take_byte() % kinds.size()]);
        for (unsigned i = how % 4; i > 0; --i) {
            auto const words = tools::word_settings(hand);
            auto const numbers = tools::number_settings(hand);
            auto const option = input_.take_byte();
            auto const value = input_.take_byte();
            if (words.size() + numbers.size() == 0)
                break;
            auto const chosen = option % (words.size() + numbers.size());
            if (chosen < words.size()) {
                auto const count = words[chosen].option.words.size();
                hand = tools::with_word(hand, chosen, static_cast<int>(value % count));
            } else {
                auto const& number = numbers[chosen - words.size()].option;
                hand = tools::with_number(hand, chosen - words.size(),
                                          number.least
                                              + (number.greatest - number.least) * value / 255.0);
            }
        }
        if (how / 4 % 2 == 1 && hand.needs_no_stroke())
            hand = hand.done_at_once();
        auto const words = tools::words_for(hand);
        writer_.write_tool(now(), words.name, words.arguments);
    }

    void history(unsigned which)
    {
        constexpr std::array kSteps { "undo", "undo", "redo", "begin_again" };
        writer_.write_tool(now(), kSteps[which % kSteps.size()], std::to_string(strokes_));
    }

    // An edit as a record: its kind, fields and numbers, each ended by a zero byte.
    void step()
    {
        auto const kinds = methods::all_methods().edits;
        session::EditRecord record;
        record.kind = input_.take_part();
        record.fields = input_.take_part();
        record.numbers = input_.take_part();
        auto const edit = session::edit_of(record, kinds);
        if (!edit)
            return;
        auto const words
            = document::words_for({ .status = std::string(), .edits = { *edit } }, strokes_);
        writer_.write_tool(now(), words.name, words.arguments);
    }

    void pause(unsigned which)
    {
        now_ms_ += 10 * input_.take_byte();
        if (which % 4 == 1)
            writer_.write_report(kPen, now(), {});
        else if (which % 4 == 2)
            writer_.write_report(kHeight, now(), {});
    }

    void report(unsigned which)
    {
        auto const size = std::min<std::size_t>(1 + which / 2, input_.bytes().size());
        auto const bytes = input_.bytes().first(size);
        writer_.write_report(which % 2 == 0 ? kPen : kHeight, now(), bytes);
        for (std::size_t i = 0; i < size; ++i)
            input_.take_byte();
    }

    void line()
    {
        auto const name = input_.take_part();
        writer_.write_tool(now(), name, input_.take_part());
    }

    FuzzInput input_;
    std::ostringstream text_;
    drivers::LogWriter writer_ { text_,
                                 { .devices = simple_rig(),
                                   .rig_text
                                   = calib::print_rig({ .tablet_size_mm = { 200, 100 } }) } };
    std::int64_t now_ms_ = 1000;
    std::size_t strokes_ = 0;
};

} // namespace

std::string log_of_recipe(FuzzInput input)
{
    return RecipeWriter(input).write();
}

} // namespace tractus
