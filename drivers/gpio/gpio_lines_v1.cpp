// Implements GpioLines with libgpiod 1.6 (Debian 12). There each line is an object, and all lines
// of a bulk request have the same direction.

#include "drivers/gpio/gpio_errors.h"
#include "drivers/gpio/gpio_lines.h"
#include "engine/base/check.h"

#include <array>
#include <cerrno>
#include <gpiod.h>
#include <utility>

namespace tractus::drivers {

namespace {

constexpr char kConsumer[] = "tractus"; // Name of the lines' user, shown by gpioinfo.

struct CloseChip {
    // Closing the chip also releases its lines.
    void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }
};
using Chip = std::unique_ptr<gpiod_chip, CloseChip>;

using LineValues = std::array<int, GpioLines::kMaxLines>;

// Lines of one direction, and the bit of each in GpioLines values.
struct Bulk {
    gpiod_line_bulk lines GPIOD_LINE_BULK_INITIALIZER;
    std::array<unsigned, GpioLines::kMaxLines> bits {};
    LineValues initial {};

    void add(gpiod_line* line, unsigned bit, bool value)
    {
        bits[lines.num_lines] = bit;
        initial[lines.num_lines] = value;
        gpiod_line_bulk_add(&lines, line);
    }
    bool empty() const { return lines.num_lines == 0; }
};

class GpiodLines final : public GpioLines {
public:
    GpiodLines(std::string name, Chip chip)
        : name_(std::move(name))
        , chip_(std::move(chip))
    {
    }

    // Requests the lines. Returns 0 or an errno value.
    int take(std::span<GpioLine const> lines);

    Result<void> set(std::uint32_t values) override;
    Result<std::uint32_t> get() override;

private:
    std::string name_;
    Chip chip_;
    Bulk outputs_ {};
    Bulk inputs_ {};
};

int GpiodLines::take(std::span<GpioLine const> lines)
{
    for (unsigned i = 0; i < lines.size(); ++i) {
        auto* const line = gpiod_chip_get_line(chip_.get(), lines[i].offset);
        if (!line)
            return errno;
        bool const is_output = lines[i].direction == GpioLine::Direction::Output;
        (is_output ? outputs_ : inputs_).add(line, i, lines[i].initial);
    }
    if (!outputs_.empty()
        && gpiod_line_request_bulk_output(&outputs_.lines, kConsumer, outputs_.initial.data()) != 0)
        return errno;
    if (!inputs_.empty() && gpiod_line_request_bulk_input(&inputs_.lines, kConsumer) != 0)
        return errno;
    return 0;
}

Result<void> GpiodLines::set(std::uint32_t values)
{
    LineValues bulk {};
    for (unsigned i = 0; i < outputs_.lines.num_lines; ++i)
        bulk[i] = values >> outputs_.bits[i] & 1;
    if (!outputs_.empty() && gpiod_line_set_value_bulk(&outputs_.lines, bulk.data()) != 0)
        return lost_gpio_lines(name_, errno);
    return {};
}

Result<std::uint32_t> GpiodLines::get()
{
    LineValues bulk {};
    if (!inputs_.empty() && gpiod_line_get_value_bulk(&inputs_.lines, bulk.data()) != 0)
        return lost_gpio_lines(name_, errno);
    std::uint32_t values = 0;
    for (unsigned i = 0; i < inputs_.lines.num_lines; ++i)
        values |= static_cast<std::uint32_t>(bulk[i] != 0) << inputs_.bits[i];
    return values;
}

} // namespace

Result<std::unique_ptr<GpioLines>> open_gpio_lines(std::string const& chip,
                                                   std::span<GpioLine const> lines)
{
    CHECK(lines.size() <= GpioLines::kMaxLines);
    Chip handle(gpiod_chip_open_by_name(chip.c_str()));
    if (!handle)
        handle.reset(gpiod_chip_open_by_label(chip.c_str()));
    if (!handle)
        return cannot_open_gpio_chip(chip, errno);
    auto result = std::make_unique<GpiodLines>(chip, std::move(handle));
    if (int const error_number = result->take(lines))
        return cannot_take_gpio_lines(chip, lines, error_number);
    return result;
}

std::string gpio_library_version()
{
    return gpiod_version_string();
}

} // namespace tractus::drivers
