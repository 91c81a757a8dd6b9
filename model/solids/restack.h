#pragma once

#include <memory>
#include <vector>

#include "model/board/document.h"

namespace model {

/// The same board with these thicknesses set by the user instead of those set before: new heights and messages, all
/// else as it is. The tables of elements, nets and components are shared with it (base::Table); nothing
/// is read again. Names that are no row are ignored (ask `findRow`
/// first).
[[nodiscard]] std::shared_ptr<const Document> restack(const Document& document, std::vector<ThicknessOverride> set);

}  // namespace model
