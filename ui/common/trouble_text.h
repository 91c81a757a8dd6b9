#pragma once

#include <QString>
#include <cstddef>

namespace ui {

/// "1 error, 2 warnings", without what there is none of; "no warnings" where there is neither.
[[nodiscard]] QString troubleText(std::size_t errors, std::size_t warnings);

}  // namespace ui
