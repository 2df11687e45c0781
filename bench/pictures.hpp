/// What pictures of a run cost.
#pragma once

namespace supple::bench {

/// CPU time of the default oscillatory run with and without its pictures, of a film, and of the pixels of
/// both pictures as PNG, beside a copy of them and zlib's fastest level.
void print_pictures();

}  // namespace supple::bench
