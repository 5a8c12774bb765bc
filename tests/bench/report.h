#pragma once

#include <benchmark/benchmark.h>
#include <filesystem>
#include <string>

namespace tractus {

// Limit of the work on this machine.
enum class Limit {
    Copy, // memcpy: for work that reads as much as it writes.
    Fill, // memset: for work that writes.
    Disk, // Writing a file in the folder for temporary files, the page cache included.
    Cp,   // Copying a file that the page cache holds with the program cp.
};

struct Work {
    double items = 1;      // Done in one iteration.
    std::string item = {}; // Plural noun for them: "reports", "segments".
    double bytes = 0; // What one iteration has to read (Copy) or write (Fill, Disk, Cp) at least.
                      // 0: so little that memory says nothing about the time.
    Limit limit = Limit::Copy;
    std::filesystem::path file = {}; // Limit::Cp: what cp copies, in its folder.
    // Page faults of one iteration: pages of memory that it was the first to touch, which is what
    // makes the same work take different times on different machines. Less than 0: this process'
    // own since the table's line before, so the first iteration's and what was prepared, shared
    // among all.
    double faults = -1;
};

// Adds a benchmark to the table: items per second, the time and bytes of each, the time of an
// iteration, its minor page faults, and the share of what the machine's memory or disk allows (1:
// as fast as moving the bytes and nothing else). Call it once, after the loop.
//
// The limits are measured by the same program on one thread, on blocks that no cache holds. The
// time is the thread's own; a benchmark that works on several threads needs UseRealTime().
void report(benchmark::State& state, Work const& work);

} // namespace tractus
