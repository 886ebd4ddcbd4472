#include <cmath>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

struct RangeCheck {
  template <class T>
  void operator()(const OptionField& field, const T& value) const {
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const double number = static_cast<double>(value);
      if (number >= field.min && number <= field.max) return;
      std::ostringstream text;
      text << "option " << field.name << " is " << value << ", expected " << field.min << " to "
           << field.max;
      if (*field.unit != '\0') text << ' ' << field.unit;
      throw std::invalid_argument(text.str());
    }
  }
};

}  // namespace

void CheckOptions(const Options& options) { VisitOptions(options, RangeCheck()); }

}  // namespace stereo_sgmp
