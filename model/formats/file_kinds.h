#pragma once

#include <string>
#include <string_view>

namespace model {

/// What a file that no format accepts most likely is, from its first bytes: "a PNG picture", "an XML file".
[[nodiscard]] std::string likelyKind(std::string_view head);

/// The first few of these bytes as people read them: text in quotes, anything else in hex.
[[nodiscard]] std::string firstBytes(std::string_view head);

}  // namespace model
