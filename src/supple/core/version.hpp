/// Which Supple this is.
#pragma once

namespace supple {

/// The version of the library, such as "0.1.0".
const char* version();

}  // namespace supple
