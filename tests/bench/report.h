#pragma once

#include <benchmark/benchmark.h>
#include <filesystem>
#include <string>

namespace tractus {

// Hardware limit of the work, measured on this machine.
enum class Limit {
    Copy, // For work that reads as much as it writes: the speed of memcpy.
    Fill, // For work that only writes: the speed of memset.
    Disk, // For writing files: the speed of writing a temporary file, without waiting for the disk.
    Cp,   // For writing files: the speed of copying a file in the page cache with the program cp.
};

struct Work {
    double items = 1;      // Items processed in one iteration.
    std::string item = {}; // Plural noun for the items: "reports", "segments".
    // Bytes that one iteration has to read (Copy) or write (Fill, Disk, Cp) at least. 0: there are
    // so few that memory does not limit the time.
    double bytes = 0;
    Limit limit = Limit::Copy;
    std::filesystem::path file = {}; // For Limit::Cp, the file to copy within its folder.
    // Page faults of one iteration: memory pages touched for the first time, which make the same
    // work take different times on different machines. Negative: the page faults of this process
    // since the previous line of the table are used, including those of the first iteration and of
    // shared preparations.
    double faults = -1;
};

// Adds a benchmark to the table: items per second, time and bytes of one item, time of an
// iteration, its minor page faults, and the speed as a share of the hardware limit (1: as fast as
// only moving the bytes). Call it once, after the benchmark's loop.
//
// The limits are measured by the same program on one thread, with blocks larger than any cache. The
// time is the thread's own; a benchmark with several threads needs UseRealTime().
void report(benchmark::State& state, Work const& work);

} // namespace tractus
