#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"

namespace model::kicad {

/// A list or an atom of KiCad's S-expressions as it lies in a Tree: a list is followed by all that is in it.
struct Node {
    enum class Kind : std::uint8_t { List, Word, Text };
    const char* begin = nullptr;  ///< as written: a list with its parentheses, a text without its quotes
    std::uint32_t size = 0;       ///< in bytes; no more than this number holds
    std::uint32_t span = 1;       ///< how many nodes it is, itself included
    std::uint32_t line = 0;       ///< 1-based, where it begins
    Kind kind = Kind::Word;
    bool isImplicit = false;  ///< a list whose opening parenthesis the writer forgot

    [[nodiscard]] std::string_view source() const { return {begin, size}; }
};

/// What is not there.
inline constexpr Node kNoNode;

/// A look at a node. One that is not there is an empty word, so chains of look-ups need no tests.
class Item {
public:
    Item() : m_node(&kNoNode) {}
    explicit Item(const Node* node) : m_node(node) {}

    /// The items of a list, its head included.
    class Iterator {
    public:
        using value_type = Item;
        using difference_type = std::ptrdiff_t;
        explicit Iterator(const Node* node = nullptr) : m_node(node) {}
        Item operator*() const { return Item(m_node); }
        Iterator& operator++() {
            m_node += m_node->span;
            return *this;
        }
        Iterator operator++(int) {
            const Iterator old = *this;
            ++*this;
            return old;
        }
        bool operator==(const Iterator&) const = default;

    private:
        const Node* m_node;
    };
    [[nodiscard]] Iterator begin() const { return Iterator(m_node + 1); }
    [[nodiscard]] Iterator end() const { return Iterator(m_node + m_node->span); }

    [[nodiscard]] bool isThere() const { return m_node != &kNoNode; }
    [[nodiscard]] bool isList() const { return m_node->kind == Node::Kind::List; }
    [[nodiscard]] bool isQuoted() const { return m_node->kind == Node::Kind::Text; }
    [[nodiscard]] std::uint32_t line() const { return m_node->line; }
    [[nodiscard]] std::string_view source() const { return m_node->source(); }
    /// The word that a list begins with, else empty.
    [[nodiscard]] std::string_view head() const {
        return isList() && m_node->span > 1 && m_node[1].kind != Node::Kind::List ? m_node[1].source()
                                                                                  : std::string_view();
    }
    /// The item at a place; the head is at 0.
    [[nodiscard]] Item at(std::size_t place) const;
    /// The atom at a place as it is written, escapes and all; empty for lists and where there is none.
    [[nodiscard]] std::string_view word(std::size_t place) const;
    /// The same with its escapes resolved.
    [[nodiscard]] std::string text(std::size_t place) const;
    /// The first list in this one with such a head.
    [[nodiscard]] Item find(std::string_view head) const;
    /// Does the list have such an atom behind its head?
    [[nodiscard]] bool hasWord(std::string_view word) const;
    /// A flag in any of its spellings: the bare word, (word), (word yes). Absent or (word no): false.
    [[nodiscard]] bool isSet(std::string_view flag) const;

private:
    const Node* m_node;
};

/// `\"`, `\\`, `\n`, `\t`, `\r` of a quoted text.
[[nodiscard]] std::string unescaped(std::string_view source);

/// Cuts the text of a board into the items right below (kicad_pcb …), one after the other, each as a tree of views into
/// the text. Tolerant as KiCad itself, and more: a list that does not end is ended where the next footprint, track or
/// via begins a line, a parenthesis too many is passed over, a text ends with its line; all of it is
/// reported. Inside (teardrops …) a word behind a list begins a list (KiCad 9.0 forgot that parenthesis). Lines that
/// begin with # are comments. Depth costs no stack.
class BoardItems {
public:
    /// The text must outlive all items; `file` is for diagnostics.
    BoardItems(std::string_view text, std::string_view file, Diagnostics& diagnostics);

    /// Does the text begin with (kicad_pcb?
    [[nodiscard]] bool isBoard() const { return m_isBoard; }
    /// The next list, valid until the next call. False at the end.
    [[nodiscard]] bool next(Item& item);
    [[nodiscard]] float fractionRead() const;

private:
    void skipBlanks();
    void readItem();
    void readText();
    void readWord();
    void open(bool isImplicit);
    void close();
    void closeAll();
    Node& add(Node::Kind kind, const char* begin, std::size_t size);
    [[nodiscard]] bool beginsBoardItem() const;
    [[nodiscard]] bool isForgottenList() const;
    void report(Severity severity, std::uint32_t line, std::string_view text);

    std::string_view m_file;
    Diagnostics& m_diagnostics;
    const char* m_begin;
    const char* m_end;
    const char* m_at;
    const char* m_lineBegin;  ///< of the line that m_at is in
    std::uint32_t m_line = 1;
    bool m_isBoard = false;
    bool m_isClosed = false;
    std::vector<Node> m_nodes;  ///< of the item
    std::vector<std::uint32_t> m_open;
};

/// Does the head of a file look like a board of KiCad?
[[nodiscard]] bool looksLikeBoard(std::string_view head);

}  // namespace model::kicad
