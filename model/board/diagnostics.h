#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/base/ids.h"
#include "model/base/point.h"

namespace model {

enum class Severity : std::uint8_t { Info, Warning, Error };

/// Something a reader skipped, repaired or assumed. One entry per cause: the same text about the same file is counted,
/// and `line` and `element` name its first occurrence.
struct Diagnostic {
    Severity severity = Severity::Info;
    std::string file;         ///< path inside the job, or the job itself; empty if it concerns no file
    std::uint32_t line = 0;   ///< 1-based; 0 if it concerns the whole file
    std::string text;         ///< a sentence in plain words that names the item concerned; begins with a capital
    ElementId element;        ///< the element it concerns, if there is one
    std::uint32_t count = 1;  ///< how often it happened
    std::optional<base::Point> location;  ///< where it is on the board, if no element came out of it
};

/// Collects what was not read literally. Nothing in a job is dropped without an entry here. Not thread-safe: every task
/// fills its own and `append` joins them in a fixed order, so that the list does not depend on the number of threads.
class Diagnostics {
public:
    /// The first letter of `text` is made a capital. It must not hold values that differ from record to record (they
    /// would defeat the counting); the line says where.
    void report(Severity severity, std::string_view file, std::uint32_t line, std::string_view text,
                ElementId element = {});
    void append(const Diagnostics& other);
    /// All entries but those about the same file with the same text as one of `other`.
    [[nodiscard]] Diagnostics without(const Diagnostics& other) const;
    /// Entries that are more severe become no more than `most`.
    void soften(Severity most);
    /// Says where the first occurrence of an entry is to be seen, once that is known.
    void locate(std::size_t row, ElementId element, std::optional<base::Point> location);

    [[nodiscard]] const std::vector<Diagnostic>& entries() const { return m_entries; }
    [[nodiscard]] std::size_t count(Severity severity) const;

private:
    void add(const Diagnostic& entry);

    std::vector<Diagnostic> m_entries;
    std::unordered_map<std::string, std::size_t> m_rowOfCause;
};

[[nodiscard]] const char* toString(Severity severity);

}  // namespace model
