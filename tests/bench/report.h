#pragma once

#include <benchmark/benchmark.h>
#include <filesystem>
#include <string>

namespace tractus {

// Hardware limit of the work, measured on this machine.
enum class Limit {
    Copy, // For work that reads as much as it writes: memcpy.
    Fill, // For work that only writes: memset.
    Disk, // For writing a file in the folder for temporary files, including the page cache.
    Cp,   // For writing files: copying a file in the page cache with the program cp.
};

struct Work {
    double items = 1;      // Items processed in one iteration.
    std::string item = {}; // Plural noun for the items: "reports", "segments".
    // Bytes that one iteration has to read (Copy) or write (Fill, Disk, Cp) at least. 0: so few
    // that memory does not limit the time.
    double bytes = 0;
    Limit limit = Limit::Copy;
    std::filesystem::path file = {}; // For Limit::Cp, the file to copy within its folder.
    // Page faults of one iteration: memory pages touched for the first time, which make the same
    // work take different times on different machines. Negative: those of this process since the
    // table's previous line, including the first iteration and shared preparations.
    double faults = -1;
};

// Adds a benchmark to the table: items per second, time and bytes of each, time of an iteration,
// its minor page faults, and the share of the limit of the machine's memory or disk (1: as fast as
// only moving the bytes). Call it once, after the loop.
//
// The limits are measured by the same program on one thread, with blocks larger than any cache. The
// time is the thread's own; a benchmark with several threads needs UseRealTime().
void report(benchmark::State& state, Work const& work);

} // namespace tractus
