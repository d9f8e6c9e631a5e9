#pragma once
#include <cstdint>

#include "mesh/vtu/vtu_layout.h"

namespace havs {

/// visit.operator()<T>() with the C++ type of numbers of this type.
template <class Visit>
auto withNumberType(NumberType type, const Visit& visit) {
  switch (type) {
    case NumberType::int8:
      return visit.template operator()<std::int8_t>();
    case NumberType::uint8:
      return visit.template operator()<std::uint8_t>();
    case NumberType::int16:
      return visit.template operator()<std::int16_t>();
    case NumberType::uint16:
      return visit.template operator()<std::uint16_t>();
    case NumberType::int32:
      return visit.template operator()<std::int32_t>();
    case NumberType::uint32:
      return visit.template operator()<std::uint32_t>();
    case NumberType::int64:
      return visit.template operator()<std::int64_t>();
    case NumberType::uint64:
      return visit.template operator()<std::uint64_t>();
    case NumberType::float32:
      return visit.template operator()<float>();
    case NumberType::float64:
      break;
  }
  return visit.template operator()<double>();
}

}  // namespace havs
