#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace base {

/// Rows of a document. Copies share them until one is edited, so a document that differs from another in few tables
/// costs those few. Reading is as from a vector, which it turns into where one is asked for.
template <class Row>
class Table {
public:
    Table() = default;
    Table(const Table&) = default;  // and no move: what is moved from keeps its rows
    Table& operator=(const Table&) = default;
    Table(std::initializer_list<Row> rows) : m_rows(std::make_shared<std::vector<Row>>(rows)) {}

    [[nodiscard]] const Row& operator[](std::size_t row) const { return (*m_rows)[row]; }
    [[nodiscard]] const Row& back() const { return m_rows->back(); }
    [[nodiscard]] const Row& front() const { return m_rows->front(); }
    [[nodiscard]] const Row* data() const { return m_rows->data(); }
    [[nodiscard]] std::size_t size() const { return m_rows->size(); }
    [[nodiscard]] bool empty() const { return m_rows->empty(); }
    [[nodiscard]] auto begin() const { return m_rows->cbegin(); }
    [[nodiscard]] auto end() const { return m_rows->cend(); }
    operator const std::vector<Row>&() const { return *m_rows; }  // NOLINT(google-explicit-constructor)

    /// The rows to change, from here on this table's alone. For who makes a document: a frozen one has readers in other
    /// threads.
    [[nodiscard]] std::vector<Row>& edit() {
        if (m_rows.use_count() > 1) {
            m_rows = std::make_shared<std::vector<Row>>(*m_rows);
        }
        return *m_rows;
    }
    void push_back(Row row) { edit().push_back(std::move(row)); }

    [[nodiscard]] bool sharesRowsWith(const Table& other) const { return m_rows == other.m_rows; }

private:
    std::shared_ptr<std::vector<Row>> m_rows = std::make_shared<std::vector<Row>>();  // never null
};

}  // namespace base
