#pragma once

#include <nlohmann/json.hpp>

#include "model/board/document.h"
#include "model/board/holes.h"

namespace app {

/// `stackup` of `info --json`: {"board_nm": …, "rows": [{"name", "has_layer", "type", "z_nm", "thickness_nm",
/// "thickness_source", "material", "material_type", "form", "copper_oz", "copper_oz_source", "dielectric_constant",
/// "loss_tangent", "resistivity_nohm_m", "kind"}], "substacks": [{"zone", "copper_to_copper_nm", "overall_nm", "rows":
/// [{"name", "cumulative_nm"}]}], "findings": [{"check", "severity", "text", "rows"}]}, from the top. `board_nm` is
/// what the job states; what it does not state is null, and so is the `zone` of the whole board. Substacks are those of
/// model/board/stackup_table.h, findings those of stackup_checks.h.
[[nodiscard]] nlohmann::ordered_json stackupJson(const model::Document& document);

/// The same as a table on stdout, without the findings, which are messages too; nothing for a format without a stackup.
void printStackup(const model::Document& document);

/// `drills` of `info --json`: a row per layer, kind and size: {"layer", "add_type", "from", "to", "span", "kind",
/// "plated", "shape", "diameter_nm", "inside_nm" (also "open_nm", its old name), "inside_source", "length_nm",
/// "tool", "other_tools", "process", "bit", "finished_nm", "drill_nm", "count"}. The source is "assumed" where no tool
/// says how thick the plating is, and null of areas, whose diameter and length are the sides of their box and whose
/// inside is 0. The length is null of round holes; `tool` and what comes from it are null where no tool of the layer
/// fits or the job does not say; "other_tools" are the numbers of those that fit alike.
[[nodiscard]] nlohmann::ordered_json drillsJson(const model::Document& document,
                                                const std::vector<model::DrillRow>& rows);

/// The holes of the board with those of all copies on it as a table on stdout; nothing where there are none.
void printDrills(const model::Document& document);

}  // namespace app
