#pragma once

#include <cstddef>

namespace incision {

/// Largest coordinate [m] of a node, a pose or a plane. Doubles near it are 1e-7 m apart; beyond it small elements lose
/// their shape and a plane cannot tell two nodes of a body apart, and the cubes and products of lengths that later
/// stages form come nearer to overflow with nothing gained.
inline constexpr double MAX_COORDINATE = 1e9;

/// Longest name of a frame or link [bytes], far above those in use.
inline constexpr std::size_t MAX_NAME = 255;

/// Longest path of a file [bytes], as Linux has it.
inline constexpr std::size_t MAX_PATH = 4096;

}  // namespace incision
