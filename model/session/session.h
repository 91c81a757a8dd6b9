#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/document.h"

/// What a user has set for a board, over what the job says. It lies in a file of its own beside the job, which is never
/// written to. The file holds only what was changed:
///
///     {"copperscope_session": 1, "job": "amp", "thickness_nm": {"TOP": 70000}}
namespace model::session {

inline constexpr int kVersion = 1;

struct Session {
    std::vector<ThicknessOverride> thicknesses;
    bool operator==(const Session&) const = default;
};

/// A session as it was found, and what of it was not used, one sentence each.
struct LoadedSession {
    Session session;
    std::vector<std::string> ignored;
};

/// "<file or folder of the job>.copperscope.json", beside it.
[[nodiscard]] std::filesystem::path sessionPath(const std::filesystem::path& board);

/// Reads the session of a board. A missing file is an empty session. What is not for this board (another job, another
/// version, rows that the stack does not have, values that are no thickness) is named in `ignored`; nothing is an
/// error.
[[nodiscard]] LoadedSession loadSession(const std::filesystem::path& board, const Document& document);

/// Writes the session: all of it or nothing (a file beside it is written out and then renamed). An empty session
/// removes the file. What the file holds and we do not know is kept. Errors: OutputFailed with the path and the reason
/// when the folder or the disk refuses, or when the file there is of a later version or no session; it is then as
/// before.
[[nodiscard]] base::Status saveSession(const std::filesystem::path& board, const Document& document,
                                       const Session& session);

/// The document with the session's thicknesses in it.
[[nodiscard]] std::shared_ptr<const Document> applySession(std::shared_ptr<const Document> document,
                                                           const Session& session);

/// Sets `change` in the list; a thickness of 0 takes the row back to what the job says.
void setThickness(std::vector<ThicknessOverride>& list, const ThicknessOverride& change);

}  // namespace model::session
