#pragma once

#include <optional>
#include <string>
#include <string_view>

/// What the values of XML attributes mean.
namespace model::ipc2581 {

/// The number that the value is, blanks around it aside. Nothing for anything else, infinities and NaN included.
[[nodiscard]] std::optional<double> realOf(std::string_view value);
/// "true" or "1", in any case.
[[nodiscard]] bool isTrue(std::string_view value);
/// The value with its entities resolved (those of XML itself; others stay as written), as UTF-8: bytes that are none
/// are taken for Latin-1.
[[nodiscard]] std::string textOf(std::string_view value);

}  // namespace model::ipc2581
