#pragma once

#include <functional>
#include <string>

#include "model/base/units.h"

namespace model {

/// How a text that people read says a length of the board: a number, a space and its unit, which is the same for all
/// lengths. Where one may be given, none stands for µm below a millimetre and mm from there on.
using LengthWriter = std::function<std::string(base::Nm)>;

}  // namespace model
