#pragma once

#include <cstdint>

namespace base {

/// A length or coordinate in nanometres. 32 bits reach ±2.1 m; input coordinates become integers once, here, and stay
/// exact.
using Nm = std::int32_t;

inline constexpr double kNmPerMm = 1e6;
inline constexpr double kNmPerUm = 1e3;
inline constexpr double kNmPerInch = 25.4e6;
inline constexpr double kNmPerMil = 25.4e3;

/// Copper of one ounce per square foot is 34.8 µm thick (28.35 g / 929.03 cm² / 8.96 g/cm³ = 34.06; the trade rounds
/// to 1.37 mil).
inline constexpr double kNmPerOunce = 34.8e3;

/// Largest coordinate a job may use: tri/ needs |extent| <= 2^30 (1.07 m) for exact predicates.
inline constexpr Nm kMaxCoordinate = 1 << 30;

constexpr double toMm(double nm) {
    return nm / kNmPerMm;
}

}  // namespace base
