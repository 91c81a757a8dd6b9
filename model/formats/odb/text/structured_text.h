#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"

namespace model::odb {

/// One `KEY=value` line.
struct Setting {
    std::string_view key;
    std::string_view value;  ///< without the blanks around it
    std::uint32_t line = 0;
};

/// A `NAME {` … `}` block, or the settings of the file outside all blocks.
struct Block {
    std::string_view name;
    std::uint32_t line = 0;
    std::vector<Setting> settings;

    /// Value of the first setting with this key (case does not matter); empty if there is none.
    [[nodiscard]] std::string_view value(std::string_view key) const;
    /// Its line; 0 if there is none.
    [[nodiscard]] std::uint32_t lineOf(std::string_view key) const;
};

/// The structured syntax of matrix, stephdr, tools, info and attrlist files. Views point into the text.
struct StructuredText {
    Block top;
    std::vector<Block> blocks;
};

/// Lines that fit the syntax nowhere and blocks that never end are reported; what could be read is kept.
[[nodiscard]] StructuredText parseStructured(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::odb
