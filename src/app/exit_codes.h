#pragma once

namespace viewcover {

// What the commands return to the shell.
inline constexpr int kDone = 0;
inline constexpr int kLimitReached = 1;  ///< or something was left out: the result is valid
inline constexpr int kNotProved = 1;     ///< the cover is valid, but may not be the smallest
inline constexpr int kBadInput = 2;
inline constexpr int kContradicted = 3;   ///< a claim of a bundle does not hold
inline constexpr int kInterrupted = 130;  ///< as shells say it: 128 + SIGINT

}  // namespace viewcover
