#pragma once

#include <benchmark/benchmark.h>
#include <cstddef>
#include <string>

namespace tractus {

// What bounds the work on this machine.
enum class Limit {
    Copy, // memcpy of as many bytes as the work reads and writes.
    Fill, // memset of as many bytes as the work writes.
    Disk, // Writing as many bytes to a file in the folder for temporary files, page cache included.
};

struct Work {
    double items = 0; // Done in one iteration.
    std::string item; // What they are, in the plural: "reports", "segments".
    double bytes = 0; // Moved in one iteration, as `limit` counts them.
    Limit limit = Limit::Copy;
};

// Reports a benchmark's figure as items per second, and as a share of what the machine's memory or
// disk allows (1: as fast as moving the bytes and nothing else). Call it once, after the loop.
void report(benchmark::State& state, Work const& work);

// Bytes per second of the limit for blocks of `bytes`, measured here: the best of a few runs.
double limit_bytes_per_second(Limit limit, std::size_t bytes);

} // namespace tractus
