#include "app/batch/job.h"

#include <gtest/gtest.h>

namespace tractus::batch {
namespace {

TEST(JobReport, IsPrintedLineByLine)
{
    JobReport report;
    report.log = "hand.tractus-log";
    report.model = "small.l";
    report.reports = 1234;
    report.strokes = 3;
    report.notes = { "a stroke at 1.5 s changed nothing" };
    report.files = { "out/base.png" };
    report.times = { { "deriving the plant", 0.25 }, { "reading the log", 1.5 } };
    auto const text = print_report(report);
    for (char const* const line :
         { "log                   hand.tractus-log\n", "reports read          1234\n",
           "strokes               3\n", "   0.250 s  deriving the plant\n", "   1.750 s  in all\n",
           "note: a stroke at 1.5 s changed nothing\n", "wrote out/base.png\n" })
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

} // namespace
} // namespace tractus::batch
