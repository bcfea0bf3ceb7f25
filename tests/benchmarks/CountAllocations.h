#pragma once

namespace limn::benchmarks
{

/// Returns how often the process has asked for memory with `new`.
long AllocationCount();

} // namespace limn::benchmarks
