#pragma once

#include <QString>
#include <span>

#include "model/nets/net_statistics.h"
#include "ui/common/display_units.h"

namespace ui {

/// What is known of one or several nets together, in lines: pins, vias and routed length, by how much the lengths of
/// two differ, with the digits that the table has of them, and the length on each copper layer. Without `statistics`
/// the counts are left out.
[[nodiscard]] QString netsText(const model::Document& document, const model::NetStatistics* statistics,
                               std::span<const model::NetId> nets, LengthUnit unit);

}  // namespace ui
