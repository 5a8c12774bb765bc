#include "drivers/gpio/gpio_edges.h"

#include "drivers/gpio/gpio_errors.h"
#include "drivers/reports/clock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/core.h>
#include <linux/gpio.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace tractus::drivers {

namespace {

namespace fs = std::filesystem;

class EdgeDescriptor {
public:
    explicit EdgeDescriptor(int number)
        : number_(number)
    {
    }
    EdgeDescriptor(EdgeDescriptor&& other) noexcept
        : number_(std::exchange(other.number_, -1))
    {
    }
    EdgeDescriptor& operator=(EdgeDescriptor&&) = delete;
    ~EdgeDescriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }

    int number() const { return number_; }

private:
    int number_;
};

std::string kernel_name(char const (&name)[GPIO_MAX_NAME_SIZE])
{
    return { name, ::strnlen(name, sizeof name) };
}

bool is_chip_called(int chip, std::string const& name)
{
    gpiochip_info info {};
    return ::ioctl(chip, GPIO_GET_CHIPINFO_IOCTL, &info) == 0
        && (kernel_name(info.name) == name || kernel_name(info.label) == name);
}

// Opens the chip with this name or label. If there is none, the result is invalid, and errno is
// set. The errno of a chip without read permission takes precedence, because that chip may have the
// label, which cannot be read.
EdgeDescriptor find_edge_chip(std::string const& name)
{
    std::vector<fs::path> nodes;
    std::error_code ignored;
    for (auto const& entry : fs::directory_iterator("/dev", ignored))
        if (entry.path().filename().string().starts_with("gpiochip"))
            nodes.push_back(entry.path());
    std::sort(nodes.begin(), nodes.end());
    int error_number = ENOENT;
    for (auto const& node : nodes) {
        EdgeDescriptor chip(::open(node.c_str(), O_RDWR | O_CLOEXEC));
        if (chip.number() >= 0 && is_chip_called(chip.number(), name))
            return chip;
        if (chip.number() < 0 && errno == EACCES)
            error_number = EACCES;
    }
    errno = error_number;
    return EdgeDescriptor(-1);
}

class KernelEdges final : public GpioEdges {
public:
    KernelEdges(std::string chip, EdgeDescriptor lines, unsigned a_line)
        : chip_(std::move(chip))
        , lines_(std::move(lines))
        , a_line_(a_line)
    {
    }

    Result<void> begin(); // Determines the starting state; see find_beginning().

    Result<void> read(Duration timeout, std::vector<QuadratureEdge>& edges) override;
    Timestamp now() override { return monotonic_now(); }
    Quadrature::Beginning beginning() const override { return beginning_; }

private:
    Result<bool> wait(Duration timeout);
    Result<QuadratureLevels> levels() const;

    std::string chip_;
    EdgeDescriptor lines_;
    unsigned a_line_;
    Quadrature::Beginning beginning_ {};
};

Result<QuadratureLevels> KernelEdges::levels() const
{
    gpio_v2_line_values values { .bits = 0, .mask = 3 };
    if (::ioctl(lines_.number(), GPIO_V2_LINE_GET_VALUES_IOCTL, &values) != 0)
        return lost_gpio_lines(chip_, errno);
    return QuadratureLevels { .a = (values.bits & 1) != 0, .b = (values.bits & 2) != 0 };
}

Result<void> KernelEdges::begin()
{
    beginning_ = TRY(find_beginning(
        *this, [this] { return levels(); }, chip_));
    return {};
}

Result<bool> KernelEdges::wait(Duration timeout)
{
    auto const ms = std::chrono::ceil<std::chrono::milliseconds>(std::max(timeout, Duration(0)));
    pollfd state { .fd = lines_.number(), .events = POLLIN, .revents = 0 };
    int const count = ::poll(&state, 1, static_cast<int>(std::min<std::int64_t>(ms.count(), 1000)));
    if (count < 0 && errno != EINTR)
        return lost_gpio_lines(chip_, errno);
    if (count > 0 && (state.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0)
        return lost_gpio_lines(chip_, ENODEV);
    return count > 0;
}

Result<void> KernelEdges::read(Duration timeout, std::vector<QuadratureEdge>& edges)
{
    if (!TRY(wait(timeout)))
        return {};
    std::array<gpio_v2_line_event, 64> events {};
    auto const size = ::read(lines_.number(), events.data(), sizeof events);
    if (size < 0 && errno != EAGAIN && errno != EINTR)
        return lost_gpio_lines(chip_, errno);
    auto const count = size < 0 ? 0 : static_cast<std::size_t>(size) / sizeof events[0];
    for (std::size_t i = 0; i < count; ++i)
        edges.push_back({ .time = timestamp_ns(static_cast<std::int64_t>(events[i].timestamp_ns)),
                          .line = events[i].offset == a_line_ ? QuadratureEdge::Line::A
                                                              : QuadratureEdge::Line::B,
                          .is_rising = events[i].id == GPIO_V2_LINE_EVENT_RISING_EDGE,
                          .number = events[i].seqno });
    return {};
}

} // namespace

Result<Quadrature::Beginning>
find_beginning(GpioEdges& edges, std::function<Result<QuadratureLevels>()> const& levels,
               std::string const& chip)
{
    constexpr int kTrials = 100;
    std::uint32_t last_number = 0;
    std::vector<QuadratureEdge> read;
    // Returns true if there were no edges for `duration`.
    auto const is_quiet = [&](Duration duration) -> Result<bool> {
        read.clear();
        TRY(edges.read(duration, read));
        if (!read.empty())
            last_number = read.back().number;
        return read.empty();
    };
    auto const believed = edges.now() + kGpioEdgesSettleTime;
    while (edges.now() < believed)
        TRY(is_quiet(believed - edges.now()));
    for (int i = 0; i < kTrials; ++i) {
        auto const present = TRY(levels());
        if (TRY(is_quiet(std::chrono::milliseconds(1))))
            return Quadrature::Beginning { .a = present.a, .b = present.b, .number = last_number };
    }
    return fail(Fault::User,
                fmt::format("the encoder on the GPIO chip {} moves: let it rest, so that its "
                            "counting can begin",
                            chip));
}

Result<std::unique_ptr<GpioEdges>> open_gpio_edges(std::string const& chip, unsigned a_line,
                                                   unsigned b_line)
{
    auto const node = find_edge_chip(chip);
    if (node.number() < 0)
        return cannot_open_gpio_chip(chip, errno);
    gpio_v2_line_request request {};
    request.offsets[0] = a_line;
    request.offsets[1] = b_line;
    request.num_lines = 2;
    request.event_buffer_size = kGpioEdgesKept;
    request.config.flags
        = GPIO_V2_LINE_FLAG_INPUT | GPIO_V2_LINE_FLAG_EDGE_RISING | GPIO_V2_LINE_FLAG_EDGE_FALLING;
    std::strncpy(request.consumer, "tractus", sizeof request.consumer - 1);
    if (::ioctl(node.number(), GPIO_V2_GET_LINE_IOCTL, &request) != 0) {
        std::array const lines { GpioLine { .offset = a_line }, GpioLine { .offset = b_line } };
        return cannot_take_gpio_lines(chip, lines, errno);
    }
    auto edges = std::make_unique<KernelEdges>(chip, EdgeDescriptor(request.fd), a_line);
    TRY(edges->begin());
    return edges;
}

} // namespace tractus::drivers
