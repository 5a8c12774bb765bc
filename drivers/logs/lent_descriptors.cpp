#include "drivers/logs/lent_descriptors.h"

#include "drivers/reports/pen_layout.h"
#include "drivers/reports/report_descriptor.h"

#include <algorithm>
#include <bitset>
#include <string>
#include <vector>

namespace tractus::drivers {

namespace {

using ReportIdSet = std::bitset<256>;

// The input reports that an interface's report descriptor declares.
struct DescribedReports {
    ReportIdSet ids;     // Ids of all input reports; id 0 if the device uses no ids.
    ReportIdSet pen_ids; // Ids of the reports that carry pen data.
};

DescribedReports described_reports(DeviceInfo const& info)
{
    DescribedReports described;
    auto const descriptor = parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return described;
    for (auto const& report : descriptor->reports)
        if (report.kind == HidReportKind::Input)
            described.ids.set(report.report_id);
    for (auto const& layout : find_pen_layouts(*descriptor))
        described.pen_ids.set(layout.report_id);
    return described;
}

// Returns an interface's path without its interface number; empty if the path has no number.
std::string device_path(DeviceInfo const& info)
{
    return info.physical_path.substr(0, info.physical_path.rfind("/input"));
}

bool are_of_one_device(DeviceInfo const& a, DeviceInfo const& b)
{
    return a.bus == b.bus && a.vendor_id == b.vendor_id && a.product_id == b.product_id
        && device_path(a) == device_path(b);
}

} // namespace

void lend_descriptors(Log& log)
{
    std::vector<ReportIdSet> sent(log.devices.size());
    for (auto const& record : log.records)
        if (record.size > 0)
            sent[record.device].set(std::to_integer<std::size_t>(log.report(record).front()));
    std::vector<DescribedReports> described;
    for (auto const& info : log.devices)
        described.push_back(described_reports(info));
    for (std::size_t i = 0; i < log.devices.size(); ++i) {
        auto const& own = described[i];
        if (log.devices[i].report_descriptor.empty() || sent[i].none() || own.ids[0]
            || (sent[i] & own.ids).any())
            continue;
        for (std::size_t j = 0; j < log.devices.size(); ++j)
            if (are_of_one_device(log.devices[i], log.devices[j])
                && (sent[i] & ~described[j].ids).none() && (sent[i] & described[j].pen_ids).any()) {
                log.devices[i].report_descriptor = log.devices[j].report_descriptor;
                break;
            }
    }
}

} // namespace tractus::drivers
