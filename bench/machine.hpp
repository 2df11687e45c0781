/// What this machine can do, to compare with.
#pragma once
#include <cstddef>
#include <string>

namespace supple::bench {

/// CPU time of this process [s]: what others do on the machine counts as little as possible.
double cpu_seconds();
/// Name of the processor as the system tells it.
std::string processor_name();
/// Bytes that a copy between two arrays of together this size meets, per nanosecond.
double bytes_per_nanosecond(std::size_t bytes);
/// Time of so many divisions, independent and in vectors, per element.
double nanoseconds_of_divisions(int divisions);
/// Time of so many additions or multiplications, the two in one where there is such an instruction, per
/// element, likewise.
double nanoseconds_of_operations(double operations);

}  // namespace supple::bench
