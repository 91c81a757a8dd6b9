#include "ui/common/thickness_text.h"

#include "model/base/thickness_units.h"
#include "model/text/formatting.h"

namespace ui {

QString thicknessText(base::Nm thickness, LengthUnit unit) {
    return unit == LengthUnit::Millimetre ? QString::fromStdString(model::thicknessText(thickness))
                                          : lengthText(static_cast<double>(thickness), unit);
}

QString heightText(base::Nm height, LengthUnit unit) {
    return unit == LengthUnit::Millimetre ? QString::fromStdString(model::lengthText(height))
                                          : lengthText(static_cast<double>(height), unit);
}

model::LengthWriter lengthWriter(LengthUnit unit) {
    if (unit == LengthUnit::Millimetre) {
        return {};
    }
    return [unit](base::Nm length) { return lengthText(static_cast<double>(length), unit).toStdString(); };
}

}  // namespace ui
