#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace model {

/// On which lines the values of a JSON text stand, for messages about them. Comments are skipped. The text must be
/// valid JSON; of values nested deeper than 16 levels nothing is known.
class JsonLines {
public:
    explicit JsonLines(std::string_view text);

    /// Of a path like "/rules/0/kind" (keys as they are written): 1-based; of a path that is not there the line of the
    /// next longer one that is.
    [[nodiscard]] std::size_t of(std::string path) const;
    /// The path of a key that an object has twice; empty if there is none.
    [[nodiscard]] const std::string& duplicate() const { return m_duplicate; }

private:
    std::map<std::string, std::size_t> m_lines;
    std::string m_duplicate;
};

}  // namespace model
