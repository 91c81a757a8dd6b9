#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/base/progress.h"

namespace model::ipc2581 {

/// A start tag near the root.
struct XmlSection {
    std::string_view name;
    std::size_t offset = 0;
    std::uint32_t line = 0;
    int depth = 0;  ///< 1: the root
};

/// Where the large parts of an XML text are, so that they can be read in the order they are needed and not in the order
/// they were written. What is listed is well-formed: every section ends, with its own end tag or with the text.
struct XmlOutline {
    std::string_view text;  ///< up to the first fault
    std::vector<XmlSection> sections;
    std::string_view fault;  ///< what is wrong with the XML; empty: nothing
    std::uint32_t faultLine = 0;
    bool hasDocumentType = false;  ///< the fault is a DOCTYPE
};

/// Sections down to this depth: the parts of a step, and the entries of dictionaries.
inline constexpr int kOutlineDepth = 5;
/// Reads the text once. Cancelled: what was listed so far.
[[nodiscard]] XmlOutline outlineOf(std::string_view text, base::Progress& progress);

}  // namespace model::ipc2581
