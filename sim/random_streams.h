#pragma once

#include <cstdint>

namespace tractus::sim {

// Streams of the simulation's random numbers (RandomKey::stream): one seed serves all of them, and
// no stream depends on another.
constexpr std::uint32_t kTremorStream = 0x73'69'6d'01;
constexpr std::uint32_t kTabletTimingStream = 0x73'69'6d'02;
constexpr std::uint32_t kHeightTimingStream = 0x73'69'6d'03;
constexpr std::uint32_t kHeightNoiseStream = 0x73'69'6d'04;
constexpr std::uint32_t kTiltNoiseStream = 0x73'69'6d'06;
constexpr std::uint32_t kRulerStream = 0x73'69'6d'05;
constexpr std::uint32_t kUnkindnessStream = 0x73'69'6d'07;
constexpr std::uint32_t kHookStream = 0x73'69'6d'08;
constexpr std::uint32_t kDabStream = 0x73'69'6d'09;

} // namespace tractus::sim
