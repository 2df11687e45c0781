/// What a second thread does, on a quiet machine and on one whose cores are all taken.
#pragma once

namespace supple::bench {

/// Wall and CPU time of steps of dense discs and of forces of shells, with one and two threads in turn.
void print_threads();

}  // namespace supple::bench
