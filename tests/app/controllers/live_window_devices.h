#pragma once

#include "app/controllers/live_window.h"
#include "app/methods/all_methods.h"
#include "tests/app/simple_rig.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace tractus::controllers {

// A source that sends its reports only when the test asks for them, so that no test depends on
// timing.
class ScriptedSource : public drivers::ReportSource {
public:
    ScriptedSource(drivers::DeviceInfo info, std::vector<drivers::RawReport> reports)
        : info_(std::move(info))
        , reports_(std::move(reports))
    {
    }

    drivers::DeviceInfo const& info() const override { return info_; }

    Result<std::optional<drivers::RawReport>> read(Duration) override
    {
        if (next_ == reports_.size())
            return fail(Fault::User, "the script is over");
        return std::optional(reports_[next_++]);
    }

private:
    drivers::DeviceInfo info_;
    std::vector<drivers::RawReport> reports_;
    std::size_t next_ = 0;
};

inline drivers::RawReport arrived(std::int64_t milliseconds, std::vector<std::byte> const& bytes)
{
    drivers::RawReport report { .received = at_ms(milliseconds), .size = bytes.size() };
    std::copy(bytes.begin(), bytes.end(), report.storage.begin());
    return report;
}

// Returns devices that draw a stroke across the tablet. At the end, the pen is lifted, or the
// tablet is unplugged during the stroke if `goes_away` is true.
inline devices::LiveDevices drawing_devices(bool goes_away)
{
    std::vector<drivers::RawReport> reports;
    for (int i = 0; i < 20; ++i)
        reports.push_back(arrived(5 * i, pen_report(50 + 5 * i, 50, true)));
    reports.push_back(goes_away ? drivers::RawReport { .received = at_ms(100) }
                                : arrived(100, pen_report(150, 50, false)));
    std::vector<std::unique_ptr<drivers::ReportSource>> sources;
    sources.push_back(std::make_unique<ScriptedSource>(drivers::simple_pen(), std::move(reports)));
    return devices::LiveDevices::start(std::move(sources)).value();
}

inline LiveWindowOptions live_options()
{
    return { .methods = methods::all_methods(), .scene = small_scene(), .now = [] {
                return at_ms(100);
            } };
}

// Advances the window until it has seen the end of the devices' script. Another thread reads the
// script, and a loaded machine may delay it.
inline void advance_to_end(LiveWindow& window)
{
    while (window.state().status.find("is over") == std::string::npos) {
        window.advance(std::chrono::milliseconds(16));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace tractus::controllers
