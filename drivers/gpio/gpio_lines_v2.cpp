// Implements GpioLines with libgpiod 2 (Debian 13). There lines are offsets, and one request covers
// both directions.

#include "drivers/gpio/gpio_errors.h"
#include "drivers/gpio/gpio_lines.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <gpiod.h>
#include <utility>
#include <vector>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

constexpr char kConsumer[] = "tractus"; // Name of the lines' user, shown by gpioinfo.

// Deleter that calls the given libgpiod function.
template<auto function> struct FreeWith {
    template<typename T> void operator()(T* pointer) const { function(pointer); }
};
using Chip = std::unique_ptr<gpiod_chip, FreeWith<gpiod_chip_close>>;
using ChipInfo = std::unique_ptr<gpiod_chip_info, FreeWith<gpiod_chip_info_free>>;
using LineSettings = std::unique_ptr<gpiod_line_settings, FreeWith<gpiod_line_settings_free>>;
using LineConfig = std::unique_ptr<gpiod_line_config, FreeWith<gpiod_line_config_free>>;
using RequestConfig = std::unique_ptr<gpiod_request_config, FreeWith<gpiod_request_config_free>>;
using LineRequest = std::unique_ptr<gpiod_line_request, FreeWith<gpiod_line_request_release>>;

gpiod_line_value to_value(bool high)
{
    return high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

// Lines of one direction, and the bit of each in GpioLines values.
struct Subset {
    std::vector<unsigned> offsets {};
    std::vector<unsigned> bits {};
    std::vector<gpiod_line_value> values {};

    void add(unsigned offset, unsigned bit)
    {
        offsets.push_back(offset);
        bits.push_back(bit);
        values.push_back(GPIOD_LINE_VALUE_INACTIVE);
    }
};

class GpiodLines final : public GpioLines {
public:
    GpiodLines(std::string name, LineRequest request, std::span<GpioLine const> lines)
        : name_(std::move(name))
        , request_(std::move(request))
    {
        for (unsigned i = 0; i < lines.size(); ++i) {
            bool const is_output = lines[i].direction == GpioLine::Direction::Output;
            (is_output ? outputs_ : inputs_).add(lines[i].offset, i);
        }
    }

    Result<void> set(std::uint32_t values) override;
    Result<std::uint32_t> get() override;

private:
    std::string name_;
    LineRequest request_;
    Subset outputs_ {};
    Subset inputs_ {};
};

Result<void> GpiodLines::set(std::uint32_t values)
{
    for (std::size_t i = 0; i < outputs_.bits.size(); ++i)
        outputs_.values[i] = to_value(values >> outputs_.bits[i] & 1);
    if (!outputs_.bits.empty()
        && gpiod_line_request_set_values_subset(request_.get(), outputs_.offsets.size(),
                                                outputs_.offsets.data(), outputs_.values.data())
            != 0)
        return lost_gpio_lines(name_, errno);
    return {};
}

Result<std::uint32_t> GpiodLines::get()
{
    if (!inputs_.bits.empty()
        && gpiod_line_request_get_values_subset(request_.get(), inputs_.offsets.size(),
                                                inputs_.offsets.data(), inputs_.values.data())
            != 0)
        return lost_gpio_lines(name_, errno);
    std::uint32_t values = 0;
    for (std::size_t i = 0; i < inputs_.bits.size(); ++i)
        values |= static_cast<std::uint32_t>(inputs_.values[i] == GPIOD_LINE_VALUE_ACTIVE)
            << inputs_.bits[i];
    return values;
}

// Opens the chip if it has this name or label; otherwise null, with errno set.
Chip open_if_called(fs::path const& node, std::string const& name)
{
    if (!gpiod_is_gpiochip_device(node.c_str()))
        return nullptr;
    Chip chip(gpiod_chip_open(node.c_str()));
    ChipInfo const info(chip ? gpiod_chip_get_info(chip.get()) : nullptr);
    if (!info)
        return nullptr;
    if (name == gpiod_chip_info_get_name(info.get())
        || name == gpiod_chip_info_get_label(info.get()))
        return chip;
    errno = ENOENT;
    return nullptr;
}

// Opens the chip with this name or label. If there is none, the result is null, and errno is set.
// The errno of a chip without read permission takes precedence, because that chip may have the
// label, which cannot be read.
Chip find_chip(std::string const& name)
{
    std::vector<fs::path> nodes;
    std::error_code ignored;
    for (fs::directory_iterator entry("/dev", ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        if (entry->path().filename().string().starts_with("gpiochip"))
            nodes.push_back(entry->path());
    std::sort(nodes.begin(), nodes.end());
    int error_number = ENOENT;
    for (auto const& node : nodes) {
        if (auto chip = open_if_called(node, name))
            return chip;
        if (errno == EACCES)
            error_number = EACCES;
    }
    errno = error_number;
    return nullptr;
}

// Requests the lines; null, with errno set, if the kernel refuses.
LineRequest take(gpiod_chip& chip, std::span<GpioLine const> lines)
{
    LineSettings const settings(gpiod_line_settings_new());
    LineConfig const config(gpiod_line_config_new());
    RequestConfig const request(gpiod_request_config_new());
    if (!settings || !config || !request)
        return nullptr;
    gpiod_request_config_set_consumer(request.get(), kConsumer);
    for (auto const& line : lines) {
        bool const is_output = line.direction == GpioLine::Direction::Output;
        gpiod_line_settings_set_direction(
            settings.get(), is_output ? GPIOD_LINE_DIRECTION_OUTPUT : GPIOD_LINE_DIRECTION_INPUT);
        gpiod_line_settings_set_output_value(settings.get(), to_value(line.initial));
        if (gpiod_line_config_add_line_settings(config.get(), &line.offset, 1, settings.get()) != 0)
            return nullptr;
    }
    return LineRequest(gpiod_chip_request_lines(&chip, request.get(), config.get()));
}

} // namespace

Result<std::unique_ptr<GpioLines>> open_gpio_lines(std::string const& chip,
                                                   std::span<GpioLine const> lines)
{
    CHECK(lines.size() <= GpioLines::kMaxLines);
    auto const handle = find_chip(chip);
    if (!handle)
        return cannot_open_gpio_chip(chip, errno);
    auto request = take(*handle, lines);
    if (!request)
        return cannot_take_gpio_lines(chip, lines, errno);
    return std::make_unique<GpiodLines>(chip, std::move(request), lines);
}

std::string gpio_library_version()
{
    return gpiod_api_version();
}

} // namespace tractus::drivers
