/// How contacts look, of discs and of bodies alike.
#pragma once
#include <array>

#include "supple/draw/canvas/color.hpp"
#include "supple/model/pair_table.hpp"

namespace supple {

struct ContactStyle {
  ContactState state;
  const char* name;
  Color color;
};
/// In the order of drawing: the few that slip lie on top.
inline constexpr std::array<ContactStyle, 3> contact_styles{
    {{ContactState::permanent, "crosslink", hex(0x555555)},
     {ContactState::stick, "contact, stick", hex(0x0033AA)},
     {ContactState::slip, "contact, slip", hex(0xCC1144)}}};

}  // namespace supple
