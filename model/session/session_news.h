#pragma once

#include <string>
#include <vector>

#include "model/session/session.h"

namespace model::session {

/// The other parts of the file ("views", "measurements"; not the one that was saved) that another program changed since
/// the file was `before`. `saved` is what is known after a save that went well; with `before` null the file was empty.
[[nodiscard]] std::vector<std::string> otherNews(const KnownPart& saved, const FileContent* before);

}  // namespace model::session
