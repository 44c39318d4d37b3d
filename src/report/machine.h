#pragma once

#include <cstdint>
#include <string>

namespace viewcover {

/// What a run was measured on.
struct Machine {
  std::string processor;  ///< model name, "unknown" where the system does not tell
  std::string system;     ///< kernel name, release and architecture
  unsigned cores = 0;     ///< hardware threads
  std::uint64_t memory_kb = 0;
};
Machine this_machine();

/// Largest resident memory of this process so far, kilobytes.
std::uint64_t peak_memory_kb();

/// Resident memory of this process now, bytes.
std::uint64_t resident_memory();

/// Now, in UTC, such as "2024-05-31T12:00:00Z".
std::string utc_now();

}  // namespace viewcover
