#pragma once

#include <QString>
#include <filesystem>
#include <functional>
#include <memory>

#include "ui/workspace/loader.h"

namespace ui {

/// One part of a board's session file as whoever edits it sees it: which board it is of, and whether what stands in the
/// window stands in the file too.
class SessionPart {
public:
    using Save = std::function<base::Status(const std::filesystem::path& board, const model::Document& document)>;

    /// Another board, or the same one again. True if the part is to be taken from its session; false if what was edited
    /// stands in no file: then it stays.
    [[nodiscard]] bool open(const LoadedBoard& board);
    /// Null before the first board.
    [[nodiscard]] const model::Document* document() const { return m_document.get(); }
    [[nodiscard]] const std::filesystem::path& board() const { return m_request.path; }
    /// The board was opened without its session: nothing is written.
    [[nodiscard]] bool isWithoutSession() const { return m_request.noSession; }
    /// Saves what was edited, unless the board is open without its session. The answer is what to tell the user where
    /// that failed, and empty otherwise; `what` is that which then counts in the window alone: "The views".
    [[nodiscard]] QString save(const QString& what, const Save& save);

private:
    LoadRequest m_request;
    std::shared_ptr<const model::Document> m_document;
    bool m_isSaved = true;
};

}  // namespace ui
