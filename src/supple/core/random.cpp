#include "supple/core/random.hpp"

#include <Random123/philox.h>

namespace supple {

void RandomStream::fill_block() {
  const r123::Philox4x32::ctr_type block =
      r123::Philox4x32()({{counter_[0], counter_[1], counter_[2], counter_[3]}}, {{key_[0], key_[1]}});
  for (std::size_t k = 0; k < block_.size(); ++k) block_[k] = block.v[k];
  ++counter_[0];
  used_ = 0;
}

}  // namespace supple
