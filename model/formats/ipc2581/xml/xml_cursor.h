#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace model::ipc2581 {

/// Walks the tags of an XML text in their order, without a tree and without copies: names and values are views of the
/// text. Names are local ones ("ipc:Layer" is "Layer"). Text between tags, comments, CDATA and processing instructions
/// are passed over: IPC-2581 says everything in attributes. The text must outlive the cursor; cursors are cheap to
/// copy.
class XmlCursor {
public:
    enum class Token : std::uint8_t {
        Start,     ///< `<a …>` or `<a …/>`
        End,       ///< `</a>`
        Finished,  ///< nothing is left
        Broken     ///< no XML from here on: `problem` and `line` say what and where
    };

    /// Starts before the tag at `offset`, which is in this line.
    explicit XmlCursor(std::string_view text, std::size_t offset = 0, std::uint32_t line = 1)
        : m_text(text), m_next(offset), m_counted(offset), m_line(line) {}

    Token next();

    [[nodiscard]] std::string_view name() const { return m_name; }
    /// `<a/>`; such a tag has no end tag.
    [[nodiscard]] bool isEmpty() const { return m_isEmpty; }
    /// Where the tag begins.
    [[nodiscard]] std::size_t offset() const { return m_start; }
    /// 1-based. Counts from where it was asked last.
    [[nodiscard]] std::uint32_t line() const;
    /// How many start tags are open, the one just read included unless it is empty; relative to where the cursor began.
    [[nodiscard]] int depth() const { return m_depth; }
    /// The value of an attribute of a start tag as written, entities and all; empty if it is not there.
    [[nodiscard]] std::string_view value(std::string_view attribute) const;
    [[nodiscard]] const char* problem() const { return m_problem; }

private:
    struct Attribute {
        std::string_view name;
        std::string_view value;
    };

    Token passDeclaration();
    Token passUntil(std::string_view end, std::size_t from, const char* problem);
    Token readEnd();
    Token readStart();
    bool readAttribute(std::size_t& at);
    Token broken(const char* problem);
    [[nodiscard]] std::size_t endOfName(std::size_t from) const;

    std::string_view m_text;
    std::size_t m_next;
    std::size_t m_start = 0;
    mutable std::size_t m_counted;
    mutable std::uint32_t m_line;
    int m_depth = 0;
    bool m_isEmpty = false;
    std::string_view m_name;
    std::vector<Attribute> m_attributes;
    const char* m_problem = "";
};

/// Calls `read()` with the cursor at the start tag of each child of the element whose start tag was read last. What
/// `read` leaves of a child is passed over. Afterwards the cursor is at the element's end tag.
template <class Read>
void forEachChild(XmlCursor& at, const Read& read) {
    if (at.isEmpty()) {
        return;
    }
    const int level = at.depth();
    while (at.next() == XmlCursor::Token::Start) {
        read();
        while (at.depth() > level && at.next() <= XmlCursor::Token::End) {
        }
    }
}

}  // namespace model::ipc2581
