#pragma once

#include <string>

namespace model {

/// Appends a number with so many digits behind the point and no zeros at its end, whatever the locale.
void appendNumber(std::string& out, double value, int digits);
/// Appends so many significant digits of a number, with an exponent where that is shorter.
void appendSignificant(std::string& out, double value, int digits);

}  // namespace model
