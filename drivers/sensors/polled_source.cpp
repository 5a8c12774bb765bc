#include "drivers/sensors/polled_source.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

using namespace std::chrono_literals;

namespace {

constexpr Duration kAnswerTime = 50ms; // Longest wait for a reply; devices take about 4 ms.
constexpr Duration kSilenceLimit = 1s;
constexpr int kMaxStale = 128; // Most packets dropped at once: more than a kernel queue can hold.

// Drops late replies, which would otherwise be taken for the reply to the next command. Returns
// true if one of them shows that the settings were changed.
Result<bool> drop_stale(PacketLink& link, PacketTest const& spoils)
{
    bool is_spoilt = false;
    for (int i = 0; i < kMaxStale; ++i) {
        auto const packet = TRY(link.read(0ms));
        if (!packet)
            break;
        is_spoilt = is_spoilt || (spoils && spoils(packet->bytes()));
    }
    return is_spoilt;
}

struct Answer {
    std::optional<RawReport> report {};
    bool is_spoilt = false;
};

Result<Answer> await_answer(PacketLink& link, PacketTest const& is_reply, PacketTest const& spoils)
{
    Answer answer;
    auto const end = link.now() + kAnswerTime;
    for (auto now = link.now(); now < end; now = link.now()) {
        auto packet = TRY(link.read(end - now));
        if (!packet)
            break;
        if (is_reply(packet->bytes())) {
            answer.report = *packet;
            break;
        }
        answer.is_spoilt = answer.is_spoilt || (spoils && spoils(packet->bytes()));
    }
    return answer;
}

class PolledSource final : public ReportSource {
public:
    PolledSource(DeviceInfo info, std::unique_ptr<PacketLink> link, Polling polling)
        : info_(std::move(info))
        , link_(std::move(link))
        , polling_(std::move(polling))
        , last_answer_(link_->now())
        , next_question_(link_->now())
    {
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    Result<std::optional<RawReport>> ask();

    DeviceInfo info_;
    std::unique_ptr<PacketLink> link_;
    Polling polling_;
    Timestamp last_answer_;
    Timestamp next_question_;
    bool needs_set_up_ = false;
};

Result<std::optional<RawReport>> PolledSource::read(Duration timeout)
{
    auto const end = link_->now() + std::max(timeout, Duration(0));
    do {
        auto const now = link_->now();
        if (next_question_ > end) {
            link_->sleep(end - now);
            return std::optional<RawReport>();
        }
        if (next_question_ > now)
            link_->sleep(next_question_ - now);
        next_question_ = std::max(next_question_ + polling_.period, now);
        if (auto answer = TRY(ask()))
            return answer;
    } while (link_->now() < end);
    return std::optional<RawReport>();
}

Result<std::optional<RawReport>> PolledSource::ask()
{
    needs_set_up_ = TRY(drop_stale(*link_, polling_.spoils)) || needs_set_up_;
    if (needs_set_up_) {
        TRY(polling_.set_up(*link_));
        needs_set_up_ = false;
    }
    TRY(link_->write(polling_.command));
    auto answer = TRY(await_answer(*link_, polling_.is_reply, polling_.spoils));
    needs_set_up_ = needs_set_up_ || answer.is_spoilt;
    if (answer.report)
        last_answer_ = answer.report->received;
    else if (link_->now() - last_answer_ > kSilenceLimit)
        return fail(Fault::Device,
                    fmt::format("{} at {} has not answered for a second (unplug it, and plug it "
                                "in again)",
                                info_.name, info_.location));
    return answer.report;
}

} // namespace

Result<std::optional<RawReport>> exchange(PacketLink& link, std::span<std::byte const> command,
                                          PacketTest const& is_reply, int attempts)
{
    for (int i = 0; i < attempts; ++i) {
        TRY(drop_stale(link, {}));
        TRY(link.write(command));
        if (auto answer = TRY(await_answer(link, is_reply, {})); answer.report)
            return answer.report;
    }
    return std::optional<RawReport>();
}

Result<std::unique_ptr<ReportSource>> open_polled(DeviceInfo info, std::unique_ptr<PacketLink> link,
                                                  Polling polling)
{
    TRY(polling.set_up(*link));
    return std::make_unique<PolledSource>(std::move(info), std::move(link), std::move(polling));
}

} // namespace tractus::drivers
