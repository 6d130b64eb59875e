#pragma once

#include <string>

#include "incision/scene/scene.h"

namespace incision::bench {

using Cells = std::array<int, 3>;

inline constexpr Cells SMALL = {16, 4, 4}, MIDDLE = {32, 8, 8}, BIG = {64, 16, 16}, HUGE_GRID = {140, 35, 34};

/// "16x4x4"
std::string nameOf(const Cells& cells);

/// The bar 1 × 0.25 × 0.25 m held at x = 0 that swings under gravity: ν = 0.45, ρ = 1000 kg/m³, no damping, Δt = 0.01
/// s, tolerance 1e-4, two threads.
Scene bar(const Cells& cells, double young_modulus = 1e6);

/// The bar with one tilted plane at 0.3 s, through no node and at most 5 % of the elements.
Scene cutBar(const Cells& cells);

/// A plate like that of the paper's figure 8: held at one edge it bends under gravity, and five crossing cuts, one
/// every 0.1 s from 0.6 s on, make pieces of it. Those that lose the clamp fall; nothing catches them.
Scene cutPlate();

/// The organ of the demo at Δt = 5 ms, damped as there, cut three times: half through, off, and half through.
Scene cutOrgan();

/// A wall of cells, three to four times as long and high as thick, that stands on the ground under its weight, in one
/// piece or, after cuts at 0 s, in eight that rest on each other. Settings are the bar's, damped so that it comes to
/// rest.
Scene wall(const Cells& cells, bool in_pieces);

}  // namespace incision::bench
