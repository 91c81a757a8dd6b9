#pragma once

#include <QString>

#include "model/base/length_writer.h"
#include "ui/common/display_units.h"

/// Thicknesses of layers in the user's unit. In millimetres what is thin is said in µm, as the trade says it.
namespace ui {

/// "35 µm", "1.6 mm", exact to the nanometre; "1.38 mil", "0.00138 in".
[[nodiscard]] QString thicknessText(base::Nm thickness, LengthUnit unit);
/// For sums of thicknesses, to five digits in millimetres: "1.6127 mm".
[[nodiscard]] QString heightText(base::Nm height, LengthUnit unit);
/// For texts that the model makes; none for millimetres.
[[nodiscard]] model::LengthWriter lengthWriter(LengthUnit unit);

}  // namespace ui
